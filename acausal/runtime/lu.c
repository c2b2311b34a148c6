/* Sparse LU with partial pivoting (Gilbert and Peierls, SIAM J. Sci. Stat. Comput. 9, 1988), and repeated
 * factorisation with the same order of pivots, which checks that the order is still good. */
#include <math.h>
#include <stddef.h>

#include "acausal_runtime.h"

/* The diagonal is kept as pivot down to this share of the largest entry of its column. */
#define DIAGONAL 0.1
/* A repeated factorisation gives up where a pivot falls below this share of its column. */
#define DECAYED 1e-3

int ac_lu_doubles(int n, int entries_w, int capacity)
{
    return AC_LU_DOUBLES(n, entries_w, capacity);
}

int ac_lu_ints(int n, int capacity)
{
    return AC_LU_INTS(n, capacity);
}

void ac_lu_init(ac_lu *lu, double *doubles, int *ints, int entries_w)
{
    int n = lu->n;
    int capacity = lu->capacity;
    lu->ax = doubles;
    lu->lx = lu->ax + entries_w;
    lu->ux = lu->lx + capacity;
    lu->ud = lu->ux + capacity;
    lu->work = lu->ud + n;
    lu->li = ints;
    lu->ui = lu->li + capacity;
    lu->pinv = lu->ui + capacity;
    lu->mark = lu->pinv + n;
    lu->stack = lu->mark + n;
    lu->place = lu->stack + n;
    lu->reach = lu->place + n;
    lu->lp = lu->reach + n;
    lu->up = lu->lp + n + 1;
    lu->factored = 0;
}

/* Rows that the column `k` of the solution of L x = W(:, q[k]) can touch, in topological order from `top`. */
static int reached(ac_lu *lu, int k)
{
    int top = lu->n;
    int column = lu->q[k];
    for (int p = lu->ap[column]; p < lu->ap[column + 1]; p++) {
        int root = lu->ai[p];
        if (lu->mark[root] == k) {
            continue;
        }
        int depth = 0;
        lu->stack[0] = root;
        lu->mark[root] = k;
        lu->place[0] = lu->pinv[root] < 0 ? 0 : lu->lp[lu->pinv[root]];
        while (depth >= 0) {
            int row = lu->stack[depth];
            int j = lu->pinv[row];
            int end = j < 0 ? 0 : lu->lp[j + 1];
            int next = -1;
            while (lu->place[depth] < end) {
                int below = lu->li[lu->place[depth]++];
                if (lu->mark[below] != k) {
                    next = below;
                    break;
                }
            }
            if (next >= 0) {
                lu->mark[next] = k;
                depth++;
                lu->stack[depth] = next;
                lu->place[depth] = lu->pinv[next] < 0 ? 0 : lu->lp[lu->pinv[next]];
            } else {
                lu->reach[--top] = row;
                depth--;
            }
        }
    }
    return top;
}

/* The row of the pivot of column `k`: the diagonal if it is large enough; -1 where all entries are 0. */
static int pivot_row(const ac_lu *lu, int k, int top)
{
    int best = -1;
    double largest = 0.0;
    int diagonal = -1;
    for (int p = top; p < lu->n; p++) {
        int row = lu->reach[p];
        if (lu->pinv[row] >= 0) {
            continue;
        }
        double size = fabs(lu->work[row]);
        if (!(size <= largest)) {
            largest = size;
            best = row;
        }
        if (row == lu->q[k]) {
            diagonal = row;
        }
    }
    if (!(largest > 0.0) || !isfinite(largest)) {
        return -1;
    }
    return diagonal >= 0 && fabs(lu->work[diagonal]) >= DIAGONAL * largest ? diagonal : best;
}

static int searched(ac_lu *lu)
{
    int n = lu->n;
    int lower = 0;
    int upper = 0;
    for (int i = 0; i < n; i++) {
        lu->pinv[i] = -1;
        lu->mark[i] = -1;
        lu->work[i] = 0.0;
    }
    for (int k = 0; k < n; k++) {
        int top = reached(lu, k);
        int column = lu->q[k];
        if (lower + n - top > lu->capacity || upper + n - top > lu->capacity) {
            return AC_MEMORY;
        }
        lu->lp[k] = lower;
        lu->up[k] = upper;
        for (int p = top; p < n; p++) {
            lu->work[lu->reach[p]] = 0.0;
        }
        for (int p = lu->ap[column]; p < lu->ap[column + 1]; p++) {
            lu->work[lu->ai[p]] = lu->ax[p];
        }
        for (int p = top; p < n; p++) {
            int j = lu->pinv[lu->reach[p]];
            if (j < 0) {
                continue;
            }
            double value = lu->work[lu->reach[p]];
            for (int q = lu->lp[j]; q < lu->lp[j + 1]; q++) {
                lu->work[lu->li[q]] -= lu->lx[q] * value;
            }
            lu->ui[upper] = j;
            lu->ux[upper++] = value;
        }
        int row = pivot_row(lu, k, top);
        if (row < 0) {
            return AC_SINGULAR;
        }
        double pivot = lu->work[row];
        lu->ud[k] = pivot;
        lu->pinv[row] = k;
        for (int p = top; p < n; p++) {
            if (lu->pinv[lu->reach[p]] < 0) {
                lu->li[lower] = lu->reach[p];
                lu->lx[lower++] = lu->work[lu->reach[p]] / pivot;
            }
        }
        lu->lp[k + 1] = lower;
        lu->up[k + 1] = upper;
    }
    for (int p = 0; p < lower; p++) {
        lu->li[p] = lu->pinv[lu->li[p]];
    }
    lu->factored = 1;
    lu->searches++;
    return 0;
}

/* The same pivots again; 1 where one of them has become too small. */
static int repeated(ac_lu *lu)
{
    double *x = lu->work;
    for (int k = 0; k < lu->n; k++) {
        int column = lu->q[k];
        x[k] = 0.0;
        for (int p = lu->up[k]; p < lu->up[k + 1]; p++) {
            x[lu->ui[p]] = 0.0;
        }
        for (int p = lu->lp[k]; p < lu->lp[k + 1]; p++) {
            x[lu->li[p]] = 0.0;
        }
        for (int p = lu->ap[column]; p < lu->ap[column + 1]; p++) {
            x[lu->pinv[lu->ai[p]]] = lu->ax[p];
        }
        for (int p = lu->up[k]; p < lu->up[k + 1]; p++) {
            int j = lu->ui[p];
            double value = x[j];
            lu->ux[p] = value;
            for (int q = lu->lp[j]; q < lu->lp[j + 1]; q++) {
                x[lu->li[q]] -= lu->lx[q] * value;
            }
        }
        double pivot = x[k];
        double limit = fabs(pivot) / DECAYED;
        if (!(limit > 0.0) || !isfinite(limit)) {
            return 1;
        }
        lu->ud[k] = pivot;
        for (int p = lu->lp[k]; p < lu->lp[k + 1]; p++) {
            double value = x[lu->li[p]];
            if (!(fabs(value) <= limit)) {
                return 1;
            }
            lu->lx[p] = value / pivot;
        }
    }
    lu->repeats++;
    return 0;
}

int ac_lu_factor(ac_lu *lu)
{
    if (lu->factored && repeated(lu) == 0) {
        return 0;
    }
    lu->factored = 0;
    return searched(lu);
}

/* `x` and `b` may be the same. */
void ac_lu_solve(const ac_lu *lu, const double *b, double *x)
{
    double *y = lu->work;
    int n = lu->n;
    for (int i = 0; i < n; i++) {
        y[lu->pinv[i]] = b[i];
    }
    for (int k = 0; k < n; k++) {
        double value = y[k];
        for (int p = lu->lp[k]; p < lu->lp[k + 1]; p++) {
            y[lu->li[p]] -= lu->lx[p] * value;
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        double value = y[k] / lu->ud[k];
        x[lu->q[k]] = value;
        for (int p = lu->up[k]; p < lu->up[k + 1]; p++) {
            y[lu->ui[p]] -= lu->ux[p] * value;
        }
    }
}
