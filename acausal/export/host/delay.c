/* The past of delayed expressions: `delay(e, T)` is `e` at `time - T`, its first value before that.
 *
 * Values and slopes are kept at the ends of short pieces of the run and at both sides of events, and interpolated by
 * cubics between them (Hermite). What is older than the longest delay makes room for what is new. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "acausal_host.h"

#define SLACK 1e-9

/* Of one sample: values, delays, longest delays, slopes of values and of delays. */
enum { VALUE = 0, LAG = 1, LONGEST = 2, VALUE_SLOPE = 3, LAG_SLOPE = 4, PARTS = 5 };

static const double *sample(const ac_run *r, int i, int part)
{
    int at = (r->past_first + i) % r->plan->past;
    return r->past_samples + (at * PARTS + part) * r->plan->delays;
}

static double time_of(const ac_run *r, int i)
{
    return r->past_time[(r->past_first + i) % r->plan->past];
}

/* How many samples are not after `instant`. */
static int after(const ac_run *r, double instant)
{
    int low = 0;
    int high = r->past_count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (time_of(r, middle) <= instant) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

static double value(const ac_run *r, int i, double instant)
{
    int next = after(r, instant);
    if (next == 0) {
        return sample(r, 0, VALUE)[i];
    }
    double a = sample(r, next - 1, VALUE)[i];
    double slope = sample(r, next - 1, VALUE_SLOPE)[i];
    double start = time_of(r, next - 1);
    if (next == r->past_count) {
        return a + (instant - start) * slope;
    }
    double b = sample(r, next, VALUE)[i];
    double h = time_of(r, next) - start;
    double s = (instant - start) / h;
    double inner = (1.0 - s) * (h * slope * s + a * (1.0 + 2.0 * s));
    double outer = s * (b * (3.0 - 2.0 * s) - h * sample(r, next, VALUE_SLOPE)[i] * (1.0 - s));
    return h > 0.0 ? inner * (1.0 - s) + outer * s : b;
}

/* Writes the delayed values at `time`. */
void ac_past_fill(ac_run *r, double time)
{
    int last = r->past_count - 1;
    for (int i = 0; last >= 0 && i < r->plan->delays; i++) {
        double lag = sample(r, last, LAG)[i] + (time - time_of(r, last)) * sample(r, last, LAG_SLOPE)[i];
        r->u[r->plan->inputs + i] = value(r, i, time - lag);
    }
}

/* Delayed expressions, their delays and longest delays at the present point. */
void ac_delayed(ac_run *r, double *results)
{
    const ac_model *m = &r->model;
    const double *const given[7] = {m->t, m->x, r->p, r->m, r->u, r->d, m->z};
    for (int i = 0; i < 7; i++) {
        r->arg[i] = given[i];
    }
    for (int i = 0; i < 3; i++) {
        r->res[i] = results + i * r->plan->delays;
    }
    (void)r->plan->delayed(r->arg, r->res, r->iw, r->w, 0);
}

/* The shortest delay at the last sample. */
static double shortest(const ac_run *r)
{
    double least = HUGE_VAL;
    for (int i = 0; i < r->plan->delays; i++) {
        least = fmin(least, sample(r, r->past_count - 1, LAG)[i]);
    }
    return least;
}

/* Until when to integrate in one go: delayed values must be known. */
double ac_piece(const ac_run *r, double time)
{
    if (r->plan->delays == 0) {
        return HUGE_VAL;
    }
    double interval = r->settings.interval;
    return time + fmin(interval, fmax(shortest(r), 1e-3 * interval));
}

/* Room for one sample more: what no delay reaches any longer goes. */
static int room(ac_run *r, double time)
{
    double longest = 0.0;
    for (int i = 0; i < r->plan->delays; i++) {
        longest = fmax(longest, r->past_now[LONGEST * r->plan->delays + i]);
    }
    while (r->past_count > 1 && time_of(r, 1) < time - longest) {
        r->past_first = (r->past_first + 1) % r->plan->past;
        r->past_count--;
    }
    return r->past_count < r->plan->past;
}

/* Notes the delayed expressions at the present point, with their slopes over the time `ahead`. */
int ac_keep_past(ac_run *r, double ahead)
{
    const ac_plan *plan = r->plan;
    int n = plan->delays;
    double *now = r->past_now;
    double *later = now + 3 * n;
    double time = r->model.t[0];
    if (n == 0) {
        return 0;
    }
    ac_solved(r);
    ac_delayed(r, now);
    for (int i = 0; i < n; i++) {
        double lag = now[LAG * n + i];
        if (!(lag >= 0.0 && lag <= now[LONGEST * n + i] * (1.0 + SLACK))) {
            return ac_say(r, AC_FAILED, "the delay of %s is %.6g s at time %.12g s, not between 0 and %.6g s",
                          plan->delay_name[i], lag, time, now[LONGEST * n + i]);
        }
    }
    ac_rates(r);
    memcpy(r->past_x, r->model.x, (size_t)plan->states * sizeof(double));
    for (int i = 0; i < plan->states; i++) {
        r->later[i] = r->past_x[i] + ahead * r->model.xdot[i];
    }
    ac_at(r, time + ahead, r->later);
    ac_solved(r);
    ac_delayed(r, later);
    if (!room(r, time)) {
        return ac_say(r, AC_FAILED, "delays need more than %d samples of the past at time %.12g s", plan->past, time);
    }
    int at = (r->past_first + r->past_count) % plan->past;
    double *to = r->past_samples + at * PARTS * n;
    memcpy(to, now, 3 * (size_t)n * sizeof(double));
    for (int i = 0; i < n; i++) {
        to[VALUE_SLOPE * n + i] = (later[VALUE * n + i] - now[VALUE * n + i]) / ahead;
        to[LAG_SLOPE * n + i] = (later[LAG * n + i] - now[LAG * n + i]) / ahead;
    }
    r->past_time[at] = time;
    r->past_count++;
    ac_at(r, time, r->past_x);
    return 0;
}
