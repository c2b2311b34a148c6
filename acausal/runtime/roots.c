/* Zero crossings inside the last step.
 *
 * A root counts in the direction of its present mode: v = side g + slack is positive until it crosses. A root
 * that is zero when the solver starts is given a slack, so that noise around zero is no crossing, until it has
 * clearly left zero. Every step is looked at in several points, and where the size of a root has a
 * minimum between them, close to the minimum too.
 */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "acausal_runtime.h"

#define LEAST 4        /* points of a step of variable length at which roots are looked at */
#define HALVINGS 200

static double value(const ac_solver *s, int i, const double *g)
{
    return s->side[i] == 0.0 ? 1.0 : s->side[i] * g[i] + s->slack[i];
}

static int crossed(const ac_solver *s, const double *g)
{
    for (int i = 0; i < s->model->crossings; i++) {
        if (value(s, i, g) < 0.0) {
            return 1;
        }
    }
    return 0;
}

static void arm(ac_solver *s, const double *g)
{
    for (int i = 0; i < s->model->crossings; i++) {
        if (s->slack[i] > 0.0 && s->side[i] * g[i] > s->slack[i]) {
            s->slack[i] = 0.0;
        }
    }
}

/* Roots that are not looked for (side 0: known instants) may be anything. */
static int all_finite(const ac_solver *s, const double *g)
{
    for (int i = 0; i < s->model->crossings; i++) {
        if (s->side[i] != 0.0 && !isfinite(g[i])) {
            return 0;
        }
    }
    return 1;
}

static int roots_at(ac_solver *s, double t, double *g)
{
    ac_interpolate(s, t, s->stage);
    int code = ac_roots(s->model, t, s->stage, g);
    for (int i = 0; code != 0 && i < s->model->crossings; i++) {
        g[i] = NAN;
    }
    return code == 0 && !all_finite(s, g) ? AC_NOT_FINITE : code;
}

/* Where the first of the roots that differ in sign between a and b would be zero on straight lines. */
static double secant(const ac_solver *s, double a, double b, const double *ga, const double *gb)
{
    double share = 1.0;
    for (int i = 0; i < s->model->crossings; i++) {
        double va = value(s, i, ga);
        double vb = value(s, i, gb);
        if (vb < 0.0 && va > 0.0) {
            share = fmin(share, va / (va - vb));
        }
    }
    return a + share * (b - a);
}

/* Narrows [a, b], at whose end something has crossed or is no number (roots `ga`, `gb`), to rounding: the end is
 * the event. Secants and halvings take turns, so that the number of steps is bounded. Where nothing crosses before
 * it is no number, the last good point is left, and the error. */
static int located(ac_solver *s, double a, double b, double *ga, double *gb)
{
    int m = s->model->crossings;
    size_t bytes = (size_t)m * sizeof(double);
    double tolerance = 50.0 * 2.2e-16 * fmax(fabs(b), fabs(b - a));
    for (int step = 0; step < HALVINGS && b - a > tolerance; step++) {
        double t = 0.5 * (a + b);
        if (step % 3 != 2) { /* the second time a little further, to get the crossing in between */
            t = secant(s, a, b, ga, gb) + (step % 3 == 1 ? 1e-3 * (b - a) : 0.0);
            t = fmin(fmax(t, a + 0.5 * tolerance), b - 0.5 * tolerance);
        }
        if (!(t > a && t < b)) {
            break;
        }
        int code = roots_at(s, t, s->g_mid);
        if (code != 0 && code != AC_NOT_FINITE) {
            return code;
        }
        if (code != 0 || crossed(s, s->g_mid)) {
            b = t;
            memcpy(gb, s->g_mid, bytes);
        } else {
            a = t;
            memcpy(ga, s->g_mid, bytes);
            arm(s, s->g_mid);
        }
    }
    int count = 0;
    for (int i = 0; i < m; i++) {
        s->crossed[i] = value(s, i, gb) < 0.0 ? (s->side[i] < 0.0 ? 1 : -1) : 0;
        count += s->crossed[i] != 0;
    }
    if (count == 0) {
        (void)roots_at(s, b, gb); /* where it is seen why */
        s->t = a;
        return AC_NOT_FINITE;
    }
    s->t = b;
    return AC_EVENT;
}

/* Between two points, the one where a parabola through three values of a root is lowest, if it may cross there. */
static double dip(const ac_solver *s, double t, double width, const double *g0, const double *g1, const double *g2)
{
    double best = 0.0;
    for (int i = 0; i < s->model->crossings; i++) {
        double v0 = value(s, i, g0);
        double v1 = value(s, i, g1);
        double v2 = value(s, i, g2);
        double curve = v0 - 2.0 * v1 + v2;
        if (!(curve > 0.0) || v1 > v0 || v1 > v2) {
            continue;
        }
        double shift = 0.5 * (v0 - v2) / curve;
        double lowest = v1 - 0.25 * (v0 - v2) * shift;
        if (lowest < 0.1 * v1 && fabs(shift) > 1e-3) {
            best = t + shift * width;
        }
    }
    return best;
}

static int looked(ac_solver *s, int points)
{
    size_t bytes = (size_t)s->model->crossings * sizeof(double);
    double width = (s->t1 - s->t0) / points;
    for (int j = 1; j <= points; j++) {
        double a = s->t0 + (j - 1) * width;
        double t = j == points ? s->t1 : s->t0 + j * width;
        int code = roots_at(s, t, s->g_new);
        if (code != 0 && code != AC_NOT_FINITE) {
            return code;
        }
        if (code != 0 || crossed(s, s->g_new)) {
            return located(s, a, t, s->g_old, s->g_new);
        }
        if (j > 1) {
            double middle = dip(s, a, width, s->g_try, s->g_old, s->g_new);
            if (middle != 0.0) {
                code = roots_at(s, middle, s->g_mid);
                if (code != 0 && code != AC_NOT_FINITE) {
                    return code;
                }
                if (code != 0 || crossed(s, s->g_mid)) {
                    int early = middle < a;
                    memcpy(s->g_new, s->g_mid, bytes);
                    return located(s, early ? a - width : a, middle, early ? s->g_try : s->g_old, s->g_new);
                }
            }
        }
        arm(s, s->g_new);
        memcpy(s->g_try, s->g_old, bytes);
        memcpy(s->g_old, s->g_new, bytes);
    }
    return 0;
}

/* Whether nothing of what was found to cross has done so at (t1, x1), and by how little at least. */
int ac_still_to_cross(ac_solver *s, double *distance)
{
    int count = 0;
    int code = roots_at(s, s->t1, s->g_mid);
    *distance = HUGE_VAL;
    for (int i = 0; code == 0 && i < s->model->crossings; i++) {
        double v = value(s, i, s->g_mid);
        if (s->crossed[i] != 0 && v < 0.0) {
            return 0;
        }
        if (s->crossed[i] != 0) {
            *distance = fmin(*distance, v);
            count++;
        }
    }
    return count > 0;
}

/* Looks for the first crossing in [t0, t1]: AC_EVENT with `t` and `crossed`, 0, or an error. */
int ac_search(ac_solver *s)
{
    int m = s->model->crossings;
    if (m == 0) {
        return 0;
    }
    if (s->method != AC_RODAS5P && !s->locate) {
        int code = roots_at(s, s->t1, s->g_new);
        if (code != 0 || !crossed(s, s->g_new)) {
            arm(s, s->g_new);
            return code;
        }
        for (int i = 0; i < m; i++) {
            s->crossed[i] = value(s, i, s->g_new) < 0.0 ? (s->side[i] < 0.0 ? 1 : -1) : 0;
        }
        s->t = s->t1;
        return AC_EVENT;
    }
    if (!s->have_dense) {
        ac_hermite(s);
    }
    int points = s->method == AC_RODAS5P ? LEAST : 1;
    double wanted = s->sample > 0.0 ? ceil((s->t1 - s->t0) / s->sample * (1.0 - 1e-9)) : 1.0;
    if (wanted > points) {
        points = wanted < (double)AC_MAX_LOOKS ? (int)wanted : AC_MAX_LOOKS;
    }
    return looked(s, points);
}
