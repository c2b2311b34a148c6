/* From event to event without coming back. Only what settles at once is done here: all else, messages included, is left
 * to the caller, with everything as it was before the event. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "cruise.h"

enum { SPARE = 4 }; /* rows that one event may need */

static size_t bytes(int n)
{
    return (size_t)n * sizeof(double);
}

int ac_cruise_doubles(const ac_event *e)
{
    return 2 * e->model->states + e->modes + e->frozen + e->samples + e->model->guesses;
}

void ac_cruise_init(ac_cruise *c, double *doubles)
{
    const ac_event *e = c->event;
    c->x = doubles;
    c->before_x = c->x + e->model->states;
    c->before_m = c->before_x + e->model->states;
    c->before_d = c->before_m + e->modes;
    c->before_count = c->before_d + e->frozen;
    c->before_guess = c->before_count + e->samples;
}

/* A row at (t, x); 0, or what has to be looked at: then it is not written. */
static int recorded(ac_cruise *c, double t, const double *x)
{
    ac_model *m = c->event->model;
    int code = ac_row(m, t, x, c->rows + (size_t)c->filled * (size_t)m->outputs);
    if (code == 0) {
        c->times[c->filled++] = t;
        c->last_row = t;
    }
    return code;
}

static int is_changed(const ac_cruise *c, const double *m, const double *d)
{
    const ac_event *e = c->event;
    return memcmp(m, e->m, bytes(e->modes)) != 0 || memcmp(d, e->d, bytes(e->unknowns)) != 0;
}

static void kept(ac_cruise *c)
{
    const ac_event *e = c->event;
    memcpy(c->before_x, c->x, bytes(e->model->states));
    memcpy(c->before_m, e->m, bytes(e->modes));
    memcpy(c->before_d, e->d, bytes(e->frozen));
    memcpy(c->before_count, e->sample_count, bytes(e->samples));
    memcpy(c->before_guess, e->model->guess, bytes(e->model->guesses));
}

static void undone(ac_cruise *c)
{
    ac_event *e = c->event;
    memcpy(e->m, c->before_m, bytes(e->modes));
    memcpy(e->d, c->before_d, bytes(e->frozen));
    memcpy(e->sample_count, c->before_count, bytes(e->samples));
    memcpy(e->model->guess, c->before_guess, bytes(e->model->guesses));
    e->model->settled = 0;
}

/* Settles, unless something has to be said. */
static int settled(ac_cruise *c, double t, const int *crossed)
{
    ac_event *e = c->event;
    int code = ac_event_settle(e, t, c->x, crossed);
    for (int i = 0; code == 0 && i < e->checks + e->stops; i++) {
        code = e->fired[i] != 0.0 ? AC_UNSOLVED : 0;
    }
    return code;
}

/* Ends the moment in which samples are true. */
static int closed(ac_cruise *c, double t)
{
    ac_event *e = c->event;
    double *samples = e->d + e->unknowns + e->memory;
    int any = 0;
    for (int i = 0; i < e->samples; i++) {
        any |= samples[i] != 0.0;
    }
    if (!any) {
        return 0;
    }
    double *m = e->start_m; /* free where `brief` is set */
    double *d = e->start_d;
    memcpy(m, e->m, bytes(e->modes));
    memcpy(d, e->d, bytes(e->unknowns));
    ac_event_recall(e);
    memset(samples, 0, bytes(e->samples));
    e->model->settled = 0;
    int code = settled(c, t, NULL);
    return code == 0 && is_changed(c, m, d) ? recorded(c, t, c->x) : code;
}

/* The event at (t, x), both sides of it recorded. */
static int settled_and_closed(ac_cruise *c, double t, const int *crossed, int *happened)
{
    ac_event *e = c->event;
    ac_event_at(e, t, c->x);
    ac_event_recall(e);
    int due = ac_event_due(e, t, e->start_d);
    ac_event_put(e, e->d + e->unknowns + e->memory, e->start_d, e->samples);
    int code = settled(c, t, crossed);
    if (code != 0) {
        return code;
    }
    *happened = due || is_changed(c, c->before_m, c->before_d) ||
                memcmp(c->before_x, c->x, bytes(e->model->states)) != 0;
    code = *happened ? recorded(c, t, c->x) : 0;
    return code == 0 ? closed(c, t) : code;
}

static double stop_before(const ac_cruise *c, int count)
{
    return c->recent[(c->stops - 1 - count) % AC_RECENT];
}

/* Whether the time between stops goes to zero like a geometric series, and has all but got there. */
static int shrinks(const ac_cruise *c)
{
    enum { PAIRS = AC_SHRINKING - 2 };
    if (c->stops < AC_SHRINKING) {
        return 0;
    }
    double last = stop_before(c, 0) - stop_before(c, 2);
    double first = stop_before(c, PAIRS - 1) - stop_before(c, PAIRS + 1);
    if (!(last <= fmin(c->resolved, 1e-2 * first))) {
        return 0;
    }
    for (int i = 0; i + 1 < PAIRS; i++) {
        double later = stop_before(c, i) - stop_before(c, i + 2);
        if (!(later <= stop_before(c, i + 1) - stop_before(c, i + 3))) {
            return 0;
        }
    }
    return 1;
}

/* Notes a stop and whether something happened there; AC_CROWDED where stops accumulate. */
static int noted(ac_cruise *c, double t, int happened)
{
    c->events += happened;
    c->recent[c->stops % AC_RECENT] = t;
    c->stops++;
    int dense = c->stops >= AC_RECENT && t - c->recent[c->stops % AC_RECENT] <= c->shortest;
    return dense || shrinks(c) ? AC_CROWDED : 0;
}

/* What is involved in the present stop: modes and unknowns that change, and what crossed; tallied where something
 * happened. */
static void involved(ac_cruise *c, const int *crossed, int happened)
{
    const ac_event *e = c->event;
    unsigned char *now = c->involved + (size_t)(c->stops % AC_RECENT) * (size_t)(e->modes + e->unknowns);
    for (int i = 0; i < e->modes; i++) {
        now[i] = c->before_m[i] != e->m[i] || (crossed != NULL && crossed[i] != 0);
    }
    for (int i = 0; i < e->unknowns; i++) {
        now[e->modes + i] = c->before_d[i] != e->d[i];
    }
    for (int i = 0; happened && i < e->modes + e->unknowns; i++) {
        c->tally[i] += now[i];
    }
}

/* An event at the solver's point: 0, AC_EVENT where it is left to the caller, AC_CROWDED or an error. */
static int happened(ac_cruise *c, const int *crossed)
{
    ac_solver *s = c->solver;
    ac_event *e = c->event;
    double t = ac_event_is_reached(s->t, c->next) ? c->next : s->t;
    int changed = 0;
    e->model->settled = 0;
    memcpy(c->x, s->x, bytes(e->model->states));
    if (!(c->last_row == t) && recorded(c, t, c->x) != 0) {
        return AC_EVENT;
    }
    int filled = c->filled;
    kept(c);
    if (settled_and_closed(c, t, crossed, &changed) != 0) {
        undone(c);
        c->filled = filled;
        return AC_EVENT;
    }
    involved(c, crossed, changed);
    if (noted(c, t, changed) != 0) {
        return AC_CROWDED;
    }
    ac_event_at(e, t, c->x);
    c->next = ac_event_upcoming(e, t);
    ac_event_hold(e, t, c->x, c->held);
    if (s->clock != NULL) {
        s->longest = fmax(s->longest, s->clock() - s->read + s->latest);
    }
    return ac_restart(s, t, c->x, e->side, e->slack);
}

/* The number of grid points up to `limit`. */
static int upto(const double *grid, int count, double limit)
{
    int low = 0;
    for (int high = count; low < high;) {
        int middle = low + (high - low) / 2;
        if (grid[middle] <= limit) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

int ac_cruise_on(ac_cruise *c, const double *grid, int count, double stop, ac_long budget, int *done)
{
    ac_solver *s = c->solver;
    ac_long first = s->steps + s->rejected;
    size_t width = (size_t)s->model->outputs;
    *done = c->filled = 0;
    for (;;) {
        int code = AC_REACHED;
        double limit = fmin(stop, c->next);
        int room = c->room - c->filled - SPARE;
        ac_long left = budget - (s->steps + s->rejected - first);
        if (room <= 0) {
            return AC_ROWS;
        }
        int behind = *done < count && grid[*done] <= s->t; /* rows that there was no room for */
        if (behind || !ac_event_is_reached(s->t, c->next)) {
            int wanted = upto(grid + *done, count - *done, limit);
            int filled = 0;
            s->room = room;
            code = ac_sweep(s, grid + *done, wanted, limit, left, c->rows + (size_t)c->filled * width, &filled);
            memcpy(c->times + c->filled, grid + *done, bytes(filled));
            c->filled += filled;
            *done += filled;
            if (filled > 0) {
                c->last_row = c->times[c->filled - 1];
            }
        }
        if (code == AC_ROWS) { /* all of them up to `limit`, or there is no more room */
            continue;
        }
        if (code != AC_EVENT && !(code == AC_REACHED && ac_event_is_reached(s->t, c->next))) {
            return code;
        }
        int problem = happened(c, code == AC_EVENT ? s->crossed : NULL);
        if (problem != 0) {
            return problem == AC_EVENT ? code : problem;
        }
    }
}

void ac_cruise_sizes(int *sizes)
{
    sizes[0] = (int)sizeof(ac_event);
    sizes[1] = (int)sizeof(ac_cruise);
    sizes[2] = AC_RECENT;
    sizes[3] = AC_SHRINKING;
}
