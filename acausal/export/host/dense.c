/* Small dense systems: elimination that knows singular matrices, and solutions of minimum norm. Matrices are stored
 * by rows. */
#include <math.h>
#include <string.h>

#include "acausal_host.h"

/* Different numbers around 1. */
double ac_weight(int i)
{
    double turns = (double)(i + 1) * 0.6180339887498949;
    return 0.5 + (turns - floor(turns));
}

static int pivot(double *a, int n, int k, int *order)
{
    int best = k;
    for (int i = k + 1; i < n; i++) {
        if (fabs(a[i * n + k]) > fabs(a[best * n + k])) {
            best = i;
        }
    }
    if (!(fabs(a[best * n + k]) > 0.0) || !isfinite(a[best * n + k])) {
        return 0;
    }
    for (int j = 0; best != k && j < n; j++) {
        double above = a[k * n + j];
        a[k * n + j] = a[best * n + j];
        a[best * n + j] = above;
    }
    order[k] = best;
    return 1;
}

static void substituted(const double *a, int n, double *b)
{
    for (int k = 0; k < n; k++) {
        for (int i = k + 1; i < n; i++) {
            b[i] -= a[i * n + k] * b[k];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++) {
            b[i] -= a[i * n + j] * b[j];
        }
        b[i] /= a[i * n + i];
    }
}

/* 1 where the matrix is regular; `memory` has n n + n numbers. A fixed right side beside the given one tells what is
 * singular to rounding. */
int ac_dense_solve(const double *matrix, int n, const double *right, double *solution, double *memory, int *pivots)
{
    double *a = memory;
    double *probe = memory + n * n;
    memcpy(a, matrix, (size_t)n * (size_t)n * sizeof(double));
    for (int k = 0; k < n; k++) {
        if (!pivot(a, n, k, pivots)) {
            return 0;
        }
        for (int i = k + 1; i < n; i++) {
            double factor = a[i * n + k] / a[k * n + k];
            a[i * n + k] = factor;
            for (int j = k + 1; factor != 0.0 && j < n; j++) {
                a[i * n + j] -= factor * a[k * n + j];
            }
        }
    }
    for (int i = 0; i < n; i++) {
        solution[i] = right[i];
        probe[i] = ac_weight(i);
    }
    double *const both[2] = {solution, probe};
    for (int side = 0; side < 2; side++) {
        for (int k = 0; k < n; k++) { /* rows were exchanged with their factors: all exchanges come first */
            double value = both[side][pivots[k]];
            both[side][pivots[k]] = both[side][k];
            both[side][k] = value;
        }
        substituted(a, n, both[side]);
    }
    double growth = 0.0;
    for (int i = 0; i < n; i++) {
        growth += fabs(probe[i]) + (isfinite(solution[i]) ? 0.0 : HUGE_VAL);
    }
    return growth <= 1e12;
}

/* One-sided Jacobi rotations of the columns p and q of `u` (n by n), also of `v`; whether they were not orthogonal. */
static int rotated(double *u, double *v, int n, int p, int q)
{
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;
    for (int i = 0; i < n; i++) {
        a += u[i * n + p] * u[i * n + p];
        b += u[i * n + q] * u[i * n + q];
        c += u[i * n + p] * u[i * n + q];
    }
    if (!(fabs(c) > 1e-15 * sqrt(a * b)) || c == 0.0) {
        return 0;
    }
    double zeta = (b - a) / (2.0 * c);
    double t = (zeta >= 0.0 ? 1.0 : -1.0) / (fabs(zeta) + sqrt(1.0 + zeta * zeta));
    double cosine = 1.0 / sqrt(1.0 + t * t);
    double sine = cosine * t;
    for (int i = 0; i < n; i++) {
        double *const both[2] = {u + i * n, v + i * n};
        for (int k = 0; k < 2; k++) {
            double left = both[k][p];
            both[k][p] = cosine * left - sine * both[k][q];
            both[k][q] = sine * left + cosine * both[k][q];
        }
    }
    return 1;
}

/* The shortest of the vectors that come closest to solving the system, by singular values (Hestenes 1958), of which
 * those below 1e-10 of the largest count as zero. `memory` has 2 n n + n numbers. */
void ac_minimum_norm(const double *matrix, int n, const double *right, double *solution, double *memory)
{
    double *u = memory;
    double *v = memory + n * n;
    double *size = v + n * n;
    memcpy(u, matrix, (size_t)n * (size_t)n * sizeof(double));
    for (int i = 0; i < n * n; i++) {
        v[i] = i % (n + 1) == 0 ? 1.0 : 0.0;
    }
    int moving = 1;
    for (int sweep = 0; moving && sweep < 60; sweep++) {
        moving = 0;
        for (int p = 0; p < n - 1; p++) {
            for (int q = p + 1; q < n; q++) {
                moving |= rotated(u, v, n, p, q);
            }
        }
    }
    double largest = 0.0;
    for (int j = 0; j < n; j++) {
        size[j] = 0.0;
        for (int i = 0; i < n; i++) {
            size[j] += u[i * n + j] * u[i * n + j];
        }
        largest = fmax(largest, size[j]);
        solution[j] = 0.0;
    }
    for (int j = 0; j < n; j++) {
        if (!(size[j] > 1e-20 * largest)) {
            continue;
        }
        double share = 0.0;
        for (int i = 0; i < n; i++) {
            share += u[i * n + j] * right[i];
        }
        for (int i = 0; i < n; i++) {
            solution[i] += v[i * n + j] * share / size[j];
        }
    }
}
