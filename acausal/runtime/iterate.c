/* Event iteration: modes, discrete variables and continuous unknowns that agree right after an instant.
 *
 * Inner loop: continuous blocks, modes and discrete equations are evaluated in turn until nothing changes, with the
 * values before the event fixed. Where that goes round in circles, a root that rests at exactly zero keeps its mode;
 * then one mode at a time is changed (Murty's least-index rule), and then every assignment of the modes in doubt is
 * tried. Outer loop: in its first pass a located relation has the value that its crossing gave it; then states are
 * reset, what was found becomes the value before the event, and the inner loop runs again, until that changes nothing
 * (Modelica 3.6, appendix B). All is bounded. */
#include <math.h>
#include <string.h>

#include "event.h"

enum { ITERATIONS = 50, PER_MODE = 4, FOLLOWING = 10, TRIED = 10 };

static size_t bytes(int n)
{
    return (size_t)n * sizeof(double);
}

/* The discrete equations, once, with the present modes. */
static int follow(ac_event *e)
{
    if (e->unknowns == 0) {
        return 0;
    }
    ac_event_solved(e);
    e->new_d[0] = NAN;
    (void)ac_call(&e->update);
    for (int i = 0; i < e->unknowns; i++) {
        if (!isfinite(e->new_d[i])) {
            e->which = i;
            return AC_NO_VALUE;
        }
    }
    ac_event_put(e, e->d, e->new_d, e->unknowns);
    return 0;
}

/* Makes sure that the blocks are solved here. */
static int solved(ac_event *e)
{
    int code = e->solve != NULL ? e->solve(e->owner) : ac_event_evaluate(e) ? 0 : AC_UNSOLVED;
    if (code == 0 && e->kept_z != NULL) {
        memcpy(e->kept_z, e->model->z, bytes(e->model->guesses));
    }
    return code;
}

/* One pass over blocks, modes and discrete equations. */
static int passed(ac_event *e, int one_by_one)
{
    int kept = 0;
    int code = solved(e);
    code = code == 0 ? ac_event_judge(e) : code;
    for (int i = 0; code == 0 && i < e->modes; i++) {
        if (e->wanted[i] != e->m[i]) {
            e->disputed[i] = 1;
            if (!(one_by_one && kept)) {
                e->m[i] = e->wanted[i];
            }
            kept = 1;
        }
    }
    if (kept) {
        e->model->settled = 0;
    }
    return code == 0 ? follow(e) : code;
}

static int agree(const ac_event *e, const double *m, const double *d)
{
    return memcmp(e->m, m, bytes(e->modes)) == 0 && ac_event_same(e->d, d, e->frozen);
}

static void note(const ac_event *e, double *m, double *d)
{
    memcpy(m, e->m, bytes(e->modes));
    memcpy(d, e->d, bytes(e->frozen));
}

static void back(ac_event *e, const double *m, const double *d)
{
    ac_event_put(e, e->m, m, e->modes);
    ac_event_put(e, e->d, d, e->frozen);
}

/* A few passes, of which none may come round to where another one began. */
static int settled_at_once(ac_event *e)
{
    for (int i = 0; i < AC_BRIEF; i++) {
        double *m = e->seen_m + i * e->modes;
        double *d = e->seen_d + i * e->frozen;
        note(e, m, d);
        int code = passed(e, 0);
        if (code != 0 || agree(e, m, d)) {
            return code;
        }
        for (int k = 0; k < i; k++) {
            if (agree(e, e->seen_m + k * e->modes, e->seen_d + k * e->frozen)) {
                return AC_CIRCLE;
            }
        }
    }
    return AC_CIRCLE;
}

static int iterated(ac_event *e, int one_by_one)
{
    int most = ITERATIONS + (one_by_one ? PER_MODE * e->modes : 0);
    int anchor = 1;
    note(e, e->seen_m, e->seen_d);
    for (int i = 1; i <= most; i++) {
        note(e, e->old_m, e->old_d);
        int code = passed(e, one_by_one);
        if (code != 0 || agree(e, e->old_m, e->old_d)) {
            return code;
        }
        if (agree(e, e->seen_m, e->seen_d)) {
            return AC_CIRCLE;
        }
        if (i == anchor) { /* whatever repeats is met again after twice as many steps at most (Brent 1980) */
            anchor *= 2;
            note(e, e->seen_m, e->seen_d);
        }
    }
    return AC_CIRCLE;
}

/* Whether everything agrees with the modes in doubt as they are chosen, once the rest has followed. */
static int is_consistent(ac_event *e, const int *which, int count, int choice)
{
    for (int i = 0; i < FOLLOWING; i++) { /* the discrete values of these modes, before the modes are judged */
        memcpy(e->old_d, e->d, bytes(e->frozen));
        if (follow(e) != 0) {
            return 0;
        }
        if (ac_event_same(e->old_d, e->d, e->frozen)) {
            break;
        }
    }
    for (int i = 0; i < ITERATIONS; i++) {
        note(e, e->old_m, e->old_d);
        if (passed(e, 0) != 0) {
            return 0;
        }
        for (int k = 0; k < count; k++) {
            if (e->m[which[k]] != (double)(choice >> (count - 1 - k) & 1)) {
                return 0;
            }
        }
        if (agree(e, e->old_m, e->old_d)) {
            return 1;
        }
    }
    return 0;
}

/* Every assignment of the modes in doubt, from where the circle was left; whether one is consistent. */
static int tried(ac_event *e)
{
    int which[TRIED];
    int count = 0;
    for (int i = 0; i < e->modes; i++) {
        if (e->disputed[i] && count == TRIED) {
            return 0;
        }
        if (e->disputed[i]) {
            which[count++] = i;
        }
    }
    for (e->undecided = 0; e->undecided <= 1; e->undecided++) {
        for (int choice = 0; choice < 1 << count; choice++) {
            back(e, e->seen_m, e->seen_d);
            for (int k = 0; k < count; k++) {
                e->m[which[k]] = (double)(choice >> (count - 1 - k) & 1);
            }
            e->model->settled = 0;
            if (is_consistent(e, which, count, choice)) {
                return 1;
            }
        }
    }
    return 0;
}

/* The inner loop. */
static int agreed(ac_event *e)
{
    static const int ways[3][2] = {{0, 0}, {0, 1}, {1, 0}}; /* one mode at a time; whether rest at zero is undecided */
    int code = 0;
    int first = 0;
    int which = -1;
    if (e->modes == 0 && e->frozen == 0) {
        return solved(e);
    }
    memset(e->disputed, 0, (size_t)e->modes * sizeof(int));
    if (e->brief) {
        return settled_at_once(e);
    }
    note(e, e->start_m, e->start_d);
    for (int i = 0; i < 3; i++) {
        e->undecided = ways[i][1];
        code = iterated(e, ways[i][0]);
        e->undecided = 0;
        if (code == 0) {
            return 0;
        }
        if (first == 0 && code != AC_CIRCLE) {
            first = code;
            which = e->which;
        }
        back(e, e->start_m, e->start_d);
    }
    if (code != AC_CIRCLE) {
        e->which = which;
        return first;
    }
    int fine = tried(e);
    e->undecided = 0;
    return fine ? 0 : AC_CIRCLE;
}

/* Notes checks and stops that are met, and resets states; whether any was reset, -1 where one is not finite. */
static int acted(ac_event *e)
{
    int n = e->resets;
    int c = e->checks;
    int any = 0;
    if (n + c + e->stops == 0) {
        return 0;
    }
    const double *values = e->action;
    ac_event_solved(e);
    (void)ac_call(&e->actions);
    for (int i = 0; i < c; i++) {
        if (values[2 * n + i] != 0.0 && values[2 * n + c + i] != 1.0) {
            e->fired[i] = 1.0;
        }
    }
    for (int i = 0; i < e->stops; i++) {
        if (values[2 * (n + c) + i] != 0.0) {
            e->fired[c + i] = 1.0;
        }
    }
    for (int i = 0; i < n; i++) {
        if (values[i] != 0.0 && !isfinite(values[n + i])) {
            e->which = i;
            return -1;
        }
        if (values[i] != 0.0) {
            e->x[e->reset_state[i]] = values[n + i];
            any = 1;
        }
    }
    if (any) {
        ac_event_at(e, e->time, e->x);
    }
    return any;
}

/* Notes the instant, and gives crossed relations their new values. */
static int arrived(ac_event *e, const int *crossed)
{
    e->anchored = 0;
    for (int i = 0; i < e->modes; i++) {
        e->crossed[i] = e->met[i] = crossed != NULL && crossed[i] != 0;
        e->released[i] = e->whole[i];
    }
    if (crossed == NULL) {
        return 0;
    }
    int code = solved(e);
    if (code != 0) {
        return code;
    }
    ac_event_against(e, crossed);
    memcpy(e->at_roots, e->model->roots, bytes(e->modes));
    e->anchored = e->frozen > 0;
    for (int i = 0; i < e->modes; i++) {
        if (crossed[i] != 0 && e->released[i] != 2) {
            e->m[i] = (double)(e->above[i] ? crossed[i] > 0 : crossed[i] < 0);
        }
    }
    e->model->settled = 0;
    return 0;
}

int ac_event_settle(ac_event *e, double time, double *x, const int *crossed)
{
    memset(e->fired, 0, bytes(e->checks + e->stops));
    e->time = time;
    e->undecided = 0;
    memcpy(e->x, x, bytes(e->model->states));
    ac_event_at(e, time, x);
    int code = arrived(e, crossed);
    if (code != 0 || e->frozen == 0) {
        return code != 0 ? code : agreed(e);
    }
    for (int i = 0; i < ITERATIONS; i++) {
        int again = e->anchored;
        code = agreed(e);
        if (code != 0) {
            return code;
        }
        e->anchored = 0;
        int reset = acted(e);
        if (reset < 0) {
            return AC_NO_STATE;
        }
        again |= reset;
        memcpy(e->past, e->d + e->unknowns, bytes(e->memory));
        ac_event_recall(e);
        for (int k = 0; k < e->memory; k++) {
            again |= e->judged[k] && !ac_event_same(e->past + k, e->d + e->unknowns + k, 1);
        }
        if (!again) {
            memcpy(x, e->x, bytes(e->model->states));
            return 0;
        }
    }
    e->which = -1;
    for (int k = e->memory - 1; k >= 0; k--) {
        e->which = e->judged[k] && !ac_event_same(e->past + k, e->d + e->unknowns + k, 1) ? k : e->which;
    }
    return AC_ENDLESS;
}
