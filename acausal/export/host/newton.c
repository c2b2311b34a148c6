/* A robust Newton method for one torn block: unknowns are scaled by max(|z|, nominal) and equations by the size of
 * their row, steps are halved until the residual falls or the next simplified step is shorter (Deuflhard, Newton
 * Methods for Nonlinear Problems, 2004, 3.3), and singular matrices give way to a Levenberg-Marquardt step. A solution
 * counts only if its residual is small beside differences over a short distance too. */
#include <math.h>
#include <string.h>

#include "acausal_host.h"

#define CONVERGED 1e-12
#define ACCEPTED 1e-8
#define PROBE 1e-6
#define LONGEST 1e8

enum { MOST = 500, HALVINGS = 40, ESCAPES = 4, STARTS = 9 };
enum { BRIEF = 15, STALE = 4 }; /* with that limit, iterations that gain less than half in so many are given up */
enum { LOOKS = 120, BISECTIONS = 200, POINTS = 33 };

typedef struct {
    double *z, *r, *j, *columns, *rows;
} ac_spot;

typedef struct {
    ac_run *run;
    const ac_segment *s;
    int n;
    const double *nominal;
    ac_spot now, trial;
    double *matrix, *right, *step, *size, *work;
} ac_search_of;

static double norm(const double *v, const double *rows, int n)
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) {
        double value = rows != NULL ? v[i] / rows[i] : v[i];
        sum += value * value;
    }
    return sqrt(sum);
}

/* Residual, matrix and scales at `p->z`; 0 where something is not finite. */
static int at(const ac_search_of *f, const ac_spot *p)
{
    int n = f->n;
    if (!ac_residual(f->run, f->s, p->z, p->r, p->j)) {
        return 0;
    }
    for (int i = 0; i < n; i++) {
        p->columns[i] = fmax(fabs(p->z[i]), f->nominal[i]);
    }
    for (int i = 0; i < n; i++) {
        double sum = 0.0;
        for (int k = 0; k < n; k++) {
            sum += fabs(p->j[i * n + k]) * p->columns[k];
        }
        p->rows[i] = sum > 0.0 ? sum : 1.0;
    }
    return 1;
}

static double worst(const ac_search_of *f)
{
    double most = 0.0;
    for (int i = 0; i < f->n; i++) {
        most = fmax(most, fabs(f->now.r[i] / f->now.rows[i]));
    }
    return most;
}

/* The start, or a point close to it where the equations can be evaluated. */
static int first(ac_search_of *f, const double *start)
{
    static const double distances[STARTS] = {0.0, 1e-6, -1e-6, 1e-3, -1e-3, 1e-1, -1e-1, 1.0, -1.0};
    for (int k = 0; k < STARTS; k++) {
        for (int i = 0; i < f->n; i++) {
            f->now.z[i] = start[i] + distances[k] * fmax(fabs(start[i]), f->nominal[i]) * ac_weight(i);
        }
        if (at(f, &f->now)) {
            return 1;
        }
    }
    return 0;
}

/* Whether the residual is also small beside its change over a short distance. Overwrites `trial`. */
static int is_solution(ac_search_of *f)
{
    int n = f->n;
    for (int i = 0; i < n; i++) {
        f->size[i] = PROBE * f->now.columns[i] * ac_weight(i);
        f->trial.z[i] = f->now.z[i] + f->size[i];
    }
    (void)ac_residual(f->run, f->s, f->trial.z, f->trial.r, f->trial.j);
    for (int i = 0; i < n; i++) {
        double foreseen = 0.0;
        for (int k = 0; k < n; k++) {
            foreseen += f->now.j[i * n + k] * f->size[k];
        }
        foreseen = fabs(foreseen);
        double change = fabs(f->trial.r[i] - f->now.r[i]);
        int steep = foreseen > 1e-3 * PROBE * f->now.rows[i] && change < 0.1 * foreseen;
        double size = steep ? change / PROBE : f->now.rows[i];
        if (!(fabs(f->now.r[i]) <= ACCEPTED * size)) {
            return 0;
        }
    }
    return 1;
}

/* The scaled matrix, and the scaled Newton step, regularised where the matrix is close to singular. */
static void direction(ac_search_of *f)
{
    int n = f->n;
    double largest = 0.0;
    double square = 0.0;
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < n; k++) {
            double value = f->now.j[i * n + k] * f->now.columns[k] / f->now.rows[i];
            f->matrix[i * n + k] = value;
            square += value * value;
        }
        f->right[i] = -f->now.r[i] / f->now.rows[i];
    }
    int fine = ac_dense_solve(f->matrix, n, f->right, f->step, f->work, f->run->pivots);
    for (int i = 0; fine && i < n; i++) {
        largest = fmax(largest, fabs(f->step[i]));
    }
    if (fine && largest < LONGEST) {
        return;
    }
    double *normal = f->work + n * n + n;
    for (int i = 0; i < n; i++) {
        f->size[i] = 0.0;
        for (int k = 0; k < n; k++) {
            double sum = i == k ? 1e-6 * square + 1e-300 : 0.0;
            for (int l = 0; l < n; l++) {
                sum += f->matrix[l * n + i] * f->matrix[l * n + k];
            }
            normal[i * n + k] = sum;
            f->size[i] += f->matrix[k * n + i] * f->right[k];
        }
    }
    (void)ac_dense_solve(normal, n, f->size, f->step, f->work, f->run->pivots);
}

static void exchange(ac_search_of *f)
{
    ac_spot other = f->now;
    f->now = f->trial;
    f->trial = other;
}

/* Goes the longest of the steps 1, 1/2, 1/4, ... that leads closer to a solution; 0 where none does. */
static int damped(ac_search_of *f)
{
    int n = f->n;
    double before = norm(f->now.r, f->now.rows, n);
    double length = norm(f->step, NULL, n);
    double factor = 1.0;
    for (int k = 0; k < HALVINGS; k++, factor *= 0.5) {
        for (int i = 0; i < n; i++) {
            f->trial.z[i] = f->now.z[i] + factor * f->now.columns[i] * f->step[i];
        }
        if (!at(f, &f->trial)) {
            continue;
        }
        int closer = norm(f->trial.r, f->now.rows, n) <= (1.0 - 1e-4 * factor) * before;
        if (!closer) {
            for (int i = 0; i < n; i++) {
                f->right[i] = -f->trial.r[i] / f->now.rows[i];
            }
            closer = ac_dense_solve(f->matrix, n, f->right, f->size, f->work, f->run->pivots) &&
                     norm(f->size, NULL, n) <= (1.0 - factor / 4.0) * length;
        }
        if (closer) {
            exchange(f);
            return 1;
        }
    }
    return 0;
}

/* A residual that is zero where the equations are flat is no solution: the search goes on further away. */
static int escaped(ac_search_of *f, int escapes)
{
    double distance = pow(10.0, escapes - ESCAPES);
    for (int i = 0; i < f->n; i++) {
        double away = f->now.columns[i] * ac_weight(i) * (f->step[i] < 0.0 ? -1.0 : 1.0);
        f->trial.z[i] = f->now.z[i] + distance * away;
    }
    if (!at(f, &f->trial)) {
        return 0;
    }
    exchange(f);
    return 1;
}

static int iterated(ac_search_of *f, int most)
{
    int escapes = 0;
    double course[STALE] = {0};
    for (int iteration = 0; iteration < most; iteration++) {
        double off = worst(f);
        double earlier = course[iteration % STALE];
        if (most == BRIEF && iteration >= STALE && off > 0.5 * earlier) {
            return 0;
        }
        course[iteration % STALE] = off;
        int done = off <= CONVERGED;
        if (done && is_solution(f)) {
            return 1;
        }
        direction(f);
        int moved = !done && damped(f);
        if (!moved && !done && off <= ACCEPTED && is_solution(f)) {
            return 1;
        }
        if (done && escapes < ESCAPES) {
            escapes++;
            moved = escaped(f, escapes);
        }
        if (!moved) {
            return 0;
        }
    }
    return 0;
}

static double *take(double **from, int count)
{
    double *start = *from;
    *from += count;
    return start;
}

/* The residual of a block of one unknown, and its slope. */
static double value(const ac_search_of *f, double z)
{
    f->trial.z[0] = z;
    (void)ac_residual(f->run, f->s, f->trial.z, f->trial.r, f->trial.j);
    return f->trial.r[0];
}

/* Where the sign changes between a and b. */
static double halved(const ac_search_of *f, double a, double at_a, double b)
{
    for (int i = 0; i < BISECTIONS; i++) {
        double middle = 0.5 * (a + b);
        if (middle == a || middle == b) {
            break;
        }
        if ((value(f, middle) > 0.0) == (at_a > 0.0)) {
            a = middle;
        } else {
            b = middle;
        }
    }
    return 0.5 * (a + b);
}

/* One unknown: the nearest change of sign on either side of `origin` that is a solution. */
static int bracketed(ac_search_of *f, double origin)
{
    double end[2] = {origin, origin};
    double at_end[2] = {value(f, origin), value(f, origin)};
    double step = 1e-6 * fmax(f->nominal[0], fabs(origin));
    for (int i = 0; i < 2 * LOOKS; i++) {
        int side = i % 2;
        double before = end[side];
        double at_before = at_end[side];
        double z = origin + (side == 0 ? step : -step);
        double at_z = value(f, z);
        end[side] = z;
        at_end[side] = at_z;
        if (isfinite(at_before) && isfinite(at_z) && (at_before > 0.0) != (at_z > 0.0)) {
            double middle = halved(f, before, at_before, z);
            int found = first(f, &middle) && iterated(f, MOST);
            if (found && fmin(before, z) <= f->now.z[0] && f->now.z[0] <= fmax(before, z)) {
                return 1;
            }
        }
        step *= side == 1 ? 1.5 : 1.0;
    }
    return 0;
}

/* Whether the slope has both signs between two values: a fold lies between them. */
static int turns(const ac_search_of *f, double from, double to)
{
    double least = 0.0;
    for (int pass = 0, up = 0, down = 0; pass < 2; pass++) {
        for (int i = 0; i < POINTS; i++) {
            (void)value(f, from + (to - from) * i / (POINTS - 1));
            double slope = f->trial.j[0];
            if (pass == 0 && isfinite(slope)) {
                least = fmax(least, 1e-9 * fabs(slope));
            }
            up |= pass == 1 && slope > least;
            down |= pass == 1 && slope < -least;
        }
        if (up && down) {
            return 1;
        }
    }
    return 0;
}

/* Drives the block's residuals to zero from `z` on; the known values are in `r->known`. 1 where that was possible, 2
 * where the branch of solutions ended and another one was taken, as it may be in a run. */
int ac_newton(ac_run *r, const ac_segment *s, double *z, const double *nominal, int initial)
{
    int n = s->tearing;
    double *from = r->block;
    ac_search_of f;
    f.run = r;
    f.s = s;
    f.n = n;
    f.nominal = nominal;
    ac_spot *const places[2] = {&f.now, &f.trial};
    for (int k = 0; k < 2; k++) {
        places[k]->z = take(&from, n);
        places[k]->r = take(&from, n);
        places[k]->columns = take(&from, n);
        places[k]->rows = take(&from, n);
        places[k]->j = take(&from, n * n);
    }
    f.right = take(&from, n);
    f.step = take(&from, n);
    f.size = take(&from, n);
    f.matrix = take(&from, n * n);
    f.work = from;
    int looks = n == 1 && !initial; /* looking around is better then */
    int found = first(&f, z) && iterated(&f, looks ? BRIEF : MOST);
    if (!found && looks && bracketed(&f, z[0])) {
        double solution = f.now.z[0];
        found = turns(&f, z[0], solution) ? 2 : 1;
    } else if (!found) {
        return 0;
    }
    memcpy(z, f.now.z, (size_t)n * sizeof(double));
    return found;
}
