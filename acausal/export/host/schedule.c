/* Events at known instants, and how located roots are held after an event. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "acausal_host.h"

#define EPSILON 2.220446049250313e-16
#define HYSTERESIS 1e-10
#define CLEAR 1e-11
#define REST 0.1

/* What instants near `time` may differ by and still be the same. */
static double rounding(double time)
{
    return 64.0 * EPSILON * fmax(fabs(time), 1e-300);
}

int ac_is_reached(double time, double instant)
{
    return instant - time <= rounding(time);
}

/* The samples' starts and intervals; their counts begin at `start`. */
int ac_schedule(ac_run *r, double start)
{
    const ac_plan *plan = r->plan;
    (void)ac_from(r, plan->schedule, r->p, NULL, r->sample_start, r->sample_interval);
    for (int i = 0; i < plan->samples; i++) {
        double interval = r->sample_interval[i];
        if (!(interval > 0.0 && isfinite(r->sample_start[i]))) {
            return ac_say(r, AC_FAILED, "%s has the interval %.6g s", plan->sample_name[i], interval);
        }
        r->sample_count[i] = fmax(ceil((start - r->sample_start[i] - rounding(start)) / interval), 0.0);
    }
    return 0;
}

/* The first instant after `time`; infinite if there is none. */
double ac_upcoming(ac_run *r, double time)
{
    const ac_plan *plan = r->plan;
    double next = HUGE_VAL;
    for (int i = 0; i < plan->samples; i++) {
        next = fmin(next, r->sample_start[i] + r->sample_count[i] * r->sample_interval[i]);
    }
    if (plan->instants > 0) {
        (void)ac_from(r, plan->instants_of, r->p, r->d, r->instants, NULL);
        for (int i = 0; i < plan->instants; i++) {
            if (r->instants[i] > time + rounding(time)) { /* not a number and infinity are never */
                next = fmin(next, r->instants[i]);
            }
        }
    }
    return next;
}

/* 1 for every sample whose instant this is, and 0; those instants are then past. Whether there is one. */
int ac_due(ac_run *r, double time, double *due)
{
    int any = 0;
    for (int i = 0; i < r->plan->samples; i++) {
        double instant = r->sample_start[i] + r->sample_count[i] * r->sample_interval[i];
        int now = instant <= time + fmax(rounding(time), 1e-10 * r->sample_interval[i]);
        r->sample_count[i] += now;
        due[i] = (double)now;
        any |= now;
    }
    return any;
}

/* The first kink of an input clearly after `time`; infinite if there is none. */
double ac_kink(const ac_run *r, double time)
{
    double next = HUGE_VAL;
    double after = time + 1e-12 * fmax(1.0, fabs(time));
    for (int i = 0; i < r->plan->inputs; i++) {
        int low = 0;
        int high = r->input[i].kinks;
        while (low < high) {
            int middle = low + (high - low) / 2;
            if (r->input[i].kink[middle] > after) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        if (low < r->input[i].kinks) {
            next = fmin(next, r->input[i].kink[low]);
        }
    }
    return next;
}

static void roots(ac_run *r)
{
    ac_solved(r);
    if (r->plan->modes > 0) {
        r->model.roots[0] = NAN;
        (void)ac_call(&r->model.events);
    }
}

/* The located roots after two steps along the derivatives, into `reach`: what turns round does not rest. */
static void later(ac_run *r, double ahead)
{
    const ac_plan *plan = r->plan;
    double time = r->model.t[0];
    memcpy(r->event_x, r->model.x, (size_t)plan->states * sizeof(double));
    for (int i = 1; i <= 2; i++) {
        ac_rates(r);
        for (int k = 0; k < plan->states; k++) {
            r->later[k] = r->model.x[k] + ahead * r->model.xdot[k];
        }
        ac_at(r, time + i * ahead, r->later);
    }
    roots(r);
    for (int k = 0; k < plan->located; k++) {
        r->reach[k] = r->model.roots[plan->located_at[k]];
    }
    ac_at(r, time, r->event_x);
}

/* Sets `shift`, `side` and `slack`, so that a crossing that was just handled is not found again, and rest makes no
 * event. The point is that of the run. */
void ac_hold(ac_run *r, double ahead)
{
    const ac_plan *plan = r->plan;
    int near = 0;
    memset(r->side, 0, (size_t)plan->modes * sizeof(double));
    memset(r->slack, 0, (size_t)plan->modes * sizeof(double));
    if (plan->located == 0) {
        return;
    }
    roots(r);
    (void)ac_call(&r->model.scales);
    double *root = r->wanted;
    for (int k = 0; k < plan->located; k++) {
        int i = plan->located_at[k];
        double size = isfinite(r->model.sizes[i]) ? r->model.sizes[i] : 0.0;
        root[k] = r->model.roots[i];
        r->band[k] = fmax(r->band[k], size);
        r->side[i] = plan->above[i] == (r->m[i] != 0.0) ? 1.0 : -1.0;
        double held = fmax(1.01 * fabs(root[k]), 1e-9 * size);
        r->slack[i] = r->side[i] * root[k] > CLEAR * size ? 0.0 : held;
        near |= fabs(root[k]) <= HYSTERESIS * r->band[k];
    }
    if (near) {
        later(r, ahead);
    }
    for (int k = 0; k < plan->located; k++) {
        int i = plan->located_at[k];
        double band = HYSTERESIS * r->band[k];
        if (near && fabs(root[k]) <= band && fabs(r->reach[k] - root[k]) <= REST * band) {
            r->slack[i] = fmax(r->slack[i], band);
        }
        r->shift[k] = r->side[i] * r->slack[i];
        r->slack[i] = fabs(r->shift[k]);
    }
}
