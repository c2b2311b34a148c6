/* The point, the memory and the instants of events. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "event.h"

#define EPSILON 2.220446049250313e-16

static size_t bytes(int n)
{
    return (size_t)n * sizeof(double);
}

int ac_event_doubles(const ac_event *e)
{
    int actions = 2 * (e->resets + e->checks) + e->stops;
    return AC_EVENT_DOUBLES(e->model->states, e->modes, e->frozen, e->located, actions, e->checks + e->stops,
                            e->instants);
}

int ac_event_ints(const ac_event *e)
{
    return 5 * e->modes;
}

static double *take(double **from, int count)
{
    double *start = *from;
    *from += count;
    return start;
}

void ac_event_init(ac_event *e, double *doubles, int *ints)
{
    int states = e->model->states;
    double **const of_modes[] = {&e->at_roots, &e->wanted, &e->start_m, &e->old_m, &e->side, &e->slack};
    double **const of_frozen[] = {&e->new_d, &e->new_memory, &e->start_d, &e->old_d, &e->past};
    int **const flags[] = {&e->crossed, &e->met, &e->released, &e->disputed, &e->reached};
    for (size_t i = 0; i < sizeof of_modes / sizeof of_modes[0]; i++) {
        *of_modes[i] = take(&doubles, e->modes);
    }
    for (size_t i = 0; i < sizeof of_frozen / sizeof of_frozen[0]; i++) {
        *of_frozen[i] = take(&doubles, e->frozen);
    }
    e->roots = take(&doubles, 2 * e->modes);
    e->seen_m = take(&doubles, AC_BRIEF * e->modes);
    e->seen_d = take(&doubles, AC_BRIEF * e->frozen);
    e->x = take(&doubles, states);
    e->later = take(&doubles, states);
    e->reach = take(&doubles, e->located);
    e->action = take(&doubles, 2 * (e->resets + e->checks) + e->stops);
    e->fired = take(&doubles, e->checks + e->stops);
    e->instant = take(&doubles, e->instants);
    for (size_t i = 0; i < sizeof flags / sizeof flags[0]; i++) {
        *flags[i] = ints;
        ints += e->modes;
    }
}

void ac_event_put(ac_event *e, double *to, const double *from, int n)
{
    if (n > 0 && memcmp(to, from, bytes(n)) != 0) {
        memcpy(to, from, bytes(n));
        e->model->settled = 0;
    }
}

/* The point at which the functions evaluate; where it is that already, what is known there stays so. */
void ac_event_at(ac_event *e, double time, const double *x)
{
    ac_model *m = e->model;
    if (m->settled && m->t[0] == time && (m->states == 0 || memcmp(m->x, x, bytes(m->states)) == 0)) {
        return;
    }
    m->settled = 0;
    ac_model_at(m, time, x);
}

/* Derivatives and solutions of blocks at the present point; 1 where all are finite. What was found is the next
 * guess. */
int ac_event_evaluate(ac_event *e)
{
    ac_model *m = e->model;
    int (*rescue)(void *owner, int what) = m->rescue;
    m->settled = 0;
    m->rescue = e->brief ? NULL : rescue;
    int code = ac_blocks(m);
    m->rescue = rescue;
    return code == 0;
}

void ac_event_solved(ac_event *e)
{
    if (e->model->guesses > 0 && !e->model->settled) {
        (void)ac_event_evaluate(e);
    }
}

void ac_event_recall(ac_event *e)
{
    if (e->memory > 0) {
        ac_event_solved(e);
        (void)ac_call(&e->recall);
        ac_event_put(e, e->d + e->unknowns, e->new_memory, e->memory);
    }
}

/* Equal to 1e-9: discrete numbers that come from an iteration differ by rounding. */
int ac_event_same(const double *a, const double *b, int n)
{
    for (int i = 0; i < n; i++) {
        if (!(a[i] == b[i] || fabs(a[i] - b[i]) <= 1e-9 * fmax(fabs(a[i]), fabs(b[i])))) {
            return 0;
        }
    }
    return 1;
}

/* What instants near `time` may differ by and still be the same. */
static double rounding(double time)
{
    return 64.0 * EPSILON * fmax(fabs(time), 1e-300);
}

int ac_event_is_reached(double time, double instant)
{
    return instant - time <= rounding(time);
}

double ac_event_upcoming(ac_event *e, double time)
{
    double next = HUGE_VAL;
    for (int i = 0; i < e->samples; i++) {
        next = fmin(next, e->sample_start[i] + e->sample_count[i] * e->sample_interval[i]);
    }
    if (e->instants > 0) {
        (void)ac_call(&e->ahead_of);
        for (int i = 0; i < e->instants; i++) {
            if (e->instant[i] > time + rounding(time)) { /* not a number and infinity are never */
                next = fmin(next, e->instant[i]);
            }
        }
    }
    return next;
}

int ac_event_due(ac_event *e, double time, double *due)
{
    int any = 0;
    for (int i = 0; i < e->samples; i++) {
        double instant = e->sample_start[i] + e->sample_count[i] * e->sample_interval[i];
        int now = instant <= time + fmax(rounding(time), 1e-10 * e->sample_interval[i]);
        e->sample_count[i] += now;
        due[i] = (double)now;
        any |= now;
    }
    return any;
}
