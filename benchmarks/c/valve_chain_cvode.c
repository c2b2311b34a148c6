/* The chain of valves by CVODE with KLU: prints seconds, steps, and the states at the output points. */
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_sparse.h>
#include <time.h>

#include "valve_chain.h"

static int rhs(realtype t, N_Vector x, N_Vector f, void *data)
{
    (void)data;
    derivatives(t, N_VGetArrayPointer(x), N_VGetArrayPointer(f));
    return 0;
}

/* By columns: p_i, s_i, v_i. */
static int jacobian(realtype t, N_Vector xv, N_Vector fv, SUNMatrix matrix, void *data, N_Vector a, N_Vector b,
                    N_Vector c)
{
    (void)fv, (void)data, (void)a, (void)b, (void)c;
    const double *x = N_VGetArrayPointer(xv);
    sunindextype *start = SUNSparseMatrix_IndexPointers(matrix), *row = SUNSparseMatrix_IndexValues(matrix);
    double *value = SUNSparseMatrix_Data(matrix);
    sunindextype k = 0;
    double kv = K / V, before;
    flow(H_IN, P_MEAN + P_SWING * sin(OMEGA * t) - x[0], &before);
    for (int i = 0; i < VALVES; i++) {
        double p = x[3 * i], s = x[3 * i + 1], next = i + 1 < VALVES ? x[3 * i + 3] : 0.0, slope;
        double root = sqrt(s * s + E_S * E_S), per_h;
        flow(0.5 * (s + root), p - next, &slope);
        double by_s = flow(1.0, p - next, &per_h) * 0.5 * (1.0 + s / root);
        start[3 * i] = k;
        if (i > 0) {
            row[k] = 3 * i - 3, value[k++] = kv * before;
            row[k] = 3 * i - 1, value[k++] = -A / M;
        }
        row[k] = 3 * i, value[k++] = -kv * (before + slope);
        row[k] = 3 * i + 2, value[k++] = A / M;
        if (i + 1 < VALVES) {
            row[k] = 3 * i + 3, value[k++] = kv * slope;
        }
        start[3 * i + 1] = k;
        row[k] = 3 * i, value[k++] = -kv * by_s;
        row[k] = 3 * i + 2, value[k++] = -C_S / M;
        if (i + 1 < VALVES) {
            row[k] = 3 * i + 3, value[k++] = kv * by_s;
        }
        start[3 * i + 2] = k;
        row[k] = 3 * i, value[k++] = -kv * A;
        row[k] = 3 * i + 1, value[k++] = 1.0;
        row[k] = 3 * i + 2, value[k++] = -D_S / M;
        if (i + 1 < VALVES) {
            row[k] = 3 * i + 3, value[k++] = kv * A;
        }
        before = slope;
    }
    start[N] = k;
    return 0;
}

int main(int count, char **words)
{
    double stop = atof(words[1]), rtol = count > 4 ? atof(words[4]) : 1e-6;
    int points = atoi(words[2]), repeats = atoi(words[3]);
    static double rows[100000][N];
    for (int k = 0; k < repeats; k++) {
        SUNContext context;
        SUNContext_Create(NULL, &context);
        clock_t began = clock();
        N_Vector x = N_VNew_Serial(N, context), atol = N_VNew_Serial(N, context);
        for (int i = 0; i < N; i++) {
            NV_Ith_S(x, i) = 0.0;
            NV_Ith_S(atol, i) = rtol * (i % 3 == 0 ? 1e5 : i % 3 == 1 ? 1e-3 : 0.1);
        }
        void *solver = CVodeCreate(CV_BDF, context);
        CVodeInit(solver, rhs, 0.0, x);
        CVodeSVtolerances(solver, rtol, atol);
        CVodeSetMaxNumSteps(solver, 100000000);
        SUNMatrix matrix = SUNSparseMatrix(N, N, 4 * N, CSC_MAT, context);
        SUNLinearSolver linear = SUNLinSol_KLU(x, matrix, context);
        CVodeSetLinearSolver(solver, linear, matrix);
        CVodeSetJacFn(solver, jacobian);
        for (int i = 1; i <= points; i++) {
            realtype t;
            if (CVode(solver, stop * i / points, x, &t, CV_NORMAL) < 0) {
                return 1;
            }
            for (int j = 0; j < N; j++) {
                rows[i - 1][j] = NV_Ith_S(x, j);
            }
        }
        long steps;
        CVodeGetNumSteps(solver, &steps);
        printf("%.9f %ld\n", (double)(clock() - began) / CLOCKS_PER_SEC, steps);
        CVodeFree(&solver);
        SUNLinSolFree(linear);
        SUNMatDestroy(matrix);
        N_VDestroy(x);
        N_VDestroy(atol);
        SUNContext_Free(&context);
    }
    for (int i = 0; i < points; i++) {
        for (int j = 0; j < N; j++) {
            printf("%.17g%c", rows[i][j], j + 1 < N ? ' ' : '\n');
        }
    }
    return 0;
}
