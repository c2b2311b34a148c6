/* Variable steps with RODAS5P. The step size follows Gustafsson's predictive controller (ACM TOMS 20, 1994)
 * as in Hairer and Wanner's code RODAS; the error is a root mean square over the states in units of
 * atol + rtol |x|. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "acausal_runtime.h"

#define SAFETY 0.9
#define SHRINK 5.0 /* a step is at most so many times shorter than the last */
#define GROW 6.0   /* or longer */
#define POWER 0.2  /* 1 / (order of the error estimate + 1) */

static double norm(const ac_solver *s, const double *v)
{
    int n = s->model->states;
    double sum = 0.0;
    for (int i = 0; i < n; i++) {
        double e = v[i] / s->scale[i];
        sum += e * e;
    }
    return n > 0 ? sqrt(sum / n) : 0.0;
}

static void set_scale(ac_solver *s, const double *other)
{
    for (int i = 0; i < s->model->states; i++) {
        s->scale[i] = s->atol[i] + s->rtol * fmax(fabs(s->x0[i]), fabs(other[i]));
    }
}

/* Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 1993, II.4. */
double ac_first_step(ac_solver *s, double until)
{
    int n = s->model->states;
    double span = until - s->t0;
    double longest = s->max_step > 0.0 ? fmin(s->max_step, span) : span;
    if (n == 0) {
        return longest;
    }
    set_scale(s, s->x0);
    double size = norm(s, s->x0);
    double slope = norm(s, s->f0);
    double h = size > 1e-5 && slope > 1e-5 ? 0.01 * size / slope : 1e-6;
    h = fmin(h, longest);
    for (int i = 0; i < n; i++) {
        s->stage[i] = s->x0[i] + h * s->f0[i];
    }
    if (ac_slope(s->model, s->t0 + h, s->stage, s->error) != 0) {
        return fmax(h * 1e-3, s->min_step);
    }
    for (int i = 0; i < n; i++) {
        s->error[i] = (s->error[i] - s->f0[i]) / h;
    }
    double curve = norm(s, s->error);
    double worst = fmax(slope, curve);
    double guess = worst <= 1e-15 ? fmax(1e-6, h * 1e-3) : pow(0.01 / worst, POWER);
    return fmax(fmin(fmin(100.0 * h, guess), longest), s->min_step);
}

/* The error of the last stages. */
double ac_measured(ac_solver *s)
{
    int n = s->model->states;
    if (!ac_finite(s->x1, n) || !ac_finite(s->error, n)) {
        return INFINITY;
    }
    set_scale(s, s->x1);
    double e = norm(s, s->error);
    return isfinite(e) ? e : INFINITY;
}

/* Adds each state's share of the squared error, and counts the failure for the largest. */
void ac_blame(ac_solver *s, double e, int failed)
{
    int n = s->model->states;
    if (!(e > 0.0) || !isfinite(e)) {
        return;
    }
    int worst = 0;
    double largest = -1.0;
    double total = e * e * n;
    for (int i = 0; i < n; i++) {
        double part = s->error[i] / s->scale[i];
        part = part * part / total;
        s->influence[i] += part;
        if (part > largest) {
            largest = part;
            worst = i;
        }
    }
    if (failed) {
        s->error_failures[worst]++;
    }
}

/* Counts a step whose equations could not be evaluated or solved for the state that moves fastest. */
static void blame_convergence(ac_solver *s)
{
    int worst = 0;
    double largest = -1.0;
    set_scale(s, s->x0);
    for (int i = 0; i < s->model->states; i++) {
        double rate = fabs(s->f0[i]) / s->scale[i];
        if (rate > largest) {
            largest = rate;
            worst = i;
        }
    }
    if (s->model->states > 0) {
        s->convergence_failures[worst]++;
    }
}

/* A block may have several solutions: what a trial step found far away must not be where the next one looks. */
void ac_look_from_start(ac_solver *s)
{
    ac_model *m = s->model;
    if (m->guesses > 0) {
        memcpy(m->guess, s->z0, (size_t)m->guesses * sizeof(double));
        m->settled = 0;
    }
}

static int begun(ac_solver *s, double until)
{
    ac_model *m = s->model;
    int n = m->states;
    int code = 0;
    if (s->have_end) {
        double *start = s->f1;
        s->f1 = s->f0;
        s->f0 = start;
        s->have_end = 0;
        ac_known(m, s->t0, s->x0, s->f0, s->z1);
    } else {
        code = ac_slope(m, s->t0, s->x0, s->f0);
    }
    if (code != 0) {
        return code;
    }
    if (m->guesses > 0) {
        memcpy(s->z0, m->guess, (size_t)m->guesses * sizeof(double));
    }
    if (s->first) {
        s->h_next = ac_first_step(s, until);
        s->h_accepted = s->h_next;
        ac_look_from_start(s);
    }
    code = n > 0 ? ac_matrix(m, s->t0, s->x0) : 0;
    if (code == 0 && n > 0) {
        code = ac_rate(m, s->t0, s->x0, s->f0, until - s->t0, s->ratio + m->entries);
    }
    return code;
}

static void accept(ac_solver *s, double h, double e)
{
    double factor = fmax(1.0 / GROW, fmin(SHRINK, pow(e, POWER) / SAFETY));
    if (!s->first) {
        double predicted = s->h_accepted / h * pow(e * e / s->err_accepted, POWER) / SAFETY;
        factor = fmax(factor, fmax(1.0 / GROW, fmin(SHRINK, predicted)));
    }
    double next = h / factor;
    if (s->last_rejected) {
        next = fmin(next, h);
    }
    s->h_accepted = h;
    s->err_accepted = fmax(1e-2, e);
    s->h_next = s->max_step > 0.0 ? fmin(next, s->max_step) : next;
    s->first = 0;
    s->last_rejected = 0;
    s->steps++;
}

/* The length of the next step, and where it ends. One that its limit alone keeps short ends on the grid of such steps. */
static double length(const ac_solver *s, double until, double *end)
{
    double left = until - s->t0;
    double h = fmin(s->h_next, left);
    if (s->model->crossings > 0 && s->sample > 0.0) {
        h = fmin(h, (double)AC_MAX_LOOKS * s->sample);
    }
    *end = until;
    if (h >= left * (1.0 - 1e-12)) {
        return left;
    }
    if (s->step > 0.0 && h >= s->step) {
        double next = s->origin + (floor((s->t0 - s->origin) / s->step + 1e-6) + 1.0) * s->step;
        if (next > s->t0 && next - s->t0 <= h * (1.0 + 1e-6)) {
            *end = until - next > 1e-9 * s->step ? next : until;
            return *end - s->t0;
        }
    }
    h = h > 0.5 * left ? 0.5 * left : h;
    *end = s->t0 + h;
    return h;
}

/* One accepted step from (t1, x1) on, not beyond `until`. */
int ac_variable_step(ac_solver *s, double until)
{
    int n = s->model->states;
    s->have_dense = 1;
    s->t0 = s->t1;
    memcpy(s->x0, s->x1, (size_t)n * sizeof(double));
    int code = begun(s, until);
    if (code != 0) {
        return code;
    }
    for (;;) {
        double end;
        double h = length(s, until, &end);
        double shortest = fmin(s->min_step, until - s->t0);
        code = ac_limited_step(s, h, end);
        if (code != AC_REFUSED) {
            return code;
        }
        code = n > 0 ? ac_prepare(s, h, ac_rodas5p.gamma) : 0;
        code = code == 0 ? ac_stages(s, &ac_rodas5p, h) : code;
        if (code == AC_MEMORY) {
            return code;
        }
        double e = code == 0 ? ac_measured(s) : INFINITY;
        if (code == 0 && isinf(e)) {
        }
        if (e <= 1.0) {
            ac_blame(s, e, 0);
            s->h = h;
            s->t1 = end;
            double wanted = s->last_rejected ? 0.0 : s->h_next;
            accept(s, h, fmax(e, 1e-10));
            if (h < wanted) { /* it was cut short, which says nothing against the step wanted */
                s->h_next = fmax(s->h_next, wanted);
            }
            return s->steps + s->rejected > s->max_steps ? AC_TOO_MANY_STEPS : 0;
        }
        s->rejected++;
        s->last_rejected = 1;
        ac_look_from_start(s);
        if (isinf(e)) {
            s->failures++;
            blame_convergence(s);
            s->h_next = 0.25 * h;
        } else {
            ac_blame(s, e, 1);
            s->h_next = h / fmin(SHRINK, fmax(1.0, pow(e, POWER) / SAFETY));
        }
        if (h <= shortest) {
            return code != 0 ? code : isinf(e) ? AC_NOT_FINITE : AC_STEP_TOO_SMALL;
        }
        s->h_next = fmax(s->h_next, s->min_step);
        if (s->steps + s->rejected > s->max_steps) {
            return AC_TOO_MANY_STEPS;
        }
    }
}

/* Takes the last step back; the next is of length h. */
void ac_shorter(ac_solver *s, double h)
{
    ac_look_from_start(s);
    s->t = s->t1 = s->t0;
    memcpy(s->x1, s->x0, (size_t)s->model->states * sizeof(double));
    s->have_end = 0;
    s->h_next = s->h_accepted = h;
    s->err_accepted = 1e-2;
    s->last_rejected = 1;
    s->rejected++;
}
