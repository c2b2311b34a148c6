/* Event iteration: modes, discrete variables and continuous unknowns that agree right after an instant.
 *
 * Inner loop: continuous blocks, modes and discrete equations are evaluated in turn until nothing changes, with the
 * values before the event fixed. Where that goes round in circles, a root that rests at exactly zero keeps its mode;
 * then one mode at a time is changed (Murty's least-index rule), and then every assignment of the modes in doubt is
 * tried; at last one mode at a time from the other end. Outer loop: in its first pass a located relation has the value
 * that its crossing gave it; then states are reset, what was found becomes the value before the event, and the inner
 * loop runs again, until that changes nothing (Modelica 3.6, appendix B). Where all that fails, what is about to cross at
 * the same instant has crossed, too. All is bounded. */
#include <math.h>
#include <string.h>

#include "acausal_host.h"

#define BAND 1e-9
#define NOISE 1e-14
#define ROUNDING 1e-13
#define FLAT 1e-15

enum { ITERATIONS = 50, PER_MODE = 4, FOLLOWING = 10, TRIED = 10 };
enum { ALL = 0, FIRST = 1, LAST = 2 }; /* which of the modes that differ is changed */
enum { SETTLED = 0, BROKEN = 1, CIRCLE = 2 };
enum { CIRCLING = -30, BEYOND = 2 }; /* modes go round in circles; a crossing that goes against its root's way */

static size_t bytes(int n)
{
    return (size_t)n * sizeof(double);
}

/* Writes modes or frozen values; where they change the blocks must be solved again. */
static void put(ac_run *r, double *to, const double *from, int n)
{
    if (memcmp(to, from, bytes(n)) != 0) {
        memcpy(to, from, bytes(n));
        r->model.settled = 0;
    }
}

/* What holds now is what held before the event. */
void ac_remember(ac_run *r)
{
    const ac_plan *plan = r->plan;
    if (plan->memory > 0) {
        ac_solved(r);
        (void)ac_point(r, plan->memory_of, r->before);
        put(r, r->d + plan->unknowns, r->before, plan->memory);
    }
}

/* Roots and their sizes at the present point. */
static void look(ac_run *r)
{
    ac_solved(r);
    if (r->plan->modes > 0) {
        r->model.roots[0] = NAN;
        (void)ac_call(&r->model.events);
        (void)ac_call(&r->model.scales);
    }
}

/* Roots a moment later along the derivatives; the point is the present one again. */
static void look_ahead(ac_run *r)
{
    for (int i = 0; i < r->plan->states; i++) {
        r->later[i] = r->event_x[i] + r->ahead * r->model.xdot[i];
    }
    ac_at(r, r->event_time + r->ahead, r->later);
    ac_solved(r);
    r->model.roots[0] = NAN;
    (void)ac_call(&r->model.events);
    ac_at(r, r->event_time, r->event_x);
}

/* Whether a located root is too close to zero to say that its relation lost its mode: a root that is solved for has
 * the rounding of all that is solved with it. */
static void close_ones(const ac_run *r, const double *roots, int *close)
{
    for (int i = 0; i < r->plan->modes; i++) {
        close[i] = 0;
    }
    for (int k = 0; k < r->plan->located; k++) {
        int i = r->plan->located_at[k];
        close[i] = fabs(roots[i]) <= fmax(fabs(r->shift[k]), ROUNDING * r->band[k]);
    }
}

/* The values that the relations have now, or a moment later where their root is zero, into `wanted`. A root that was
 * zero in a mode that was tried before at this instant is looked at a moment later, too. */
static int judged(ac_run *r)
{
    const ac_plan *plan = r->plan;
    const double *roots = r->model.roots;
    double *seen = r->seen_roots; /* roots and then sizes, before the functions are called again */
    int near = 0;
    look(r);
    for (int i = 0; i < plan->modes; i++) {
        if (!isfinite(roots[i])) {
            return ac_say(r, AC_FAILED, "the condition %s cannot be decided at time %.12g s: a side is not a number (%s)",
                          plan->crossing[i].text, r->event_time, plan->crossing[i].place);
        }
        seen[i] = roots[i];
        seen[plan->modes + i] = r->model.sizes[i];
    }
    ac_literal(plan, seen, r->wanted);
    close_ones(r, seen, r->reached);
    for (int i = 0; i < plan->modes; i++) {
        double band = BAND * seen[plan->modes + i];
        int crossed = r->crossed[i] != 0;
        int kept = crossed && r->anchored && !r->released[i];
        if (kept) {
            r->wanted[i] = r->m[i];
        }
        int located = crossed && fabs(seen[i] - r->event_roots[i]) <= band;
        r->reached[i] = !kept && (located || fabs(seen[i]) <= band || r->reached[i]);
        near |= r->reached[i] || (r->met[i] && !kept);
        r->met[i] |= r->reached[i];
    }
    if (!near) {
        return 0;
    }
    look_ahead(r);
    for (int i = 0; i < plan->modes; i++) {
        if (!r->met[i] || (r->crossed[i] && r->anchored && !r->released[i])) {
            continue;
        }
        if (fabs(roots[i] - seen[i]) > NOISE * seen[plan->modes + i]) {
            int positive = plan->above[i] ? roots[i] > 0.0 : -roots[i] > 0.0;
            r->wanted[i] = (double)(roots[i] == 0.0 ? plan->at_zero[i] : positive);
        } else if (r->reached[i] && (seen[i] != 0.0 || r->undecided)) {
            r->wanted[i] = r->m[i];
        }
    }
    return 0;
}

/* Releases crossings that go against the way that their root goes here: artefacts of a step below the tolerance. So a
 * ball that has just been thrown up is seen to fall, where one step covers its whole flight. */
static void against(ac_run *r, const int *crossed)
{
    const ac_plan *plan = r->plan;
    const double *roots = r->model.roots;
    double *seen = r->seen_roots;
    int near = 0;
    memcpy(seen, roots, bytes(plan->modes));
    for (int k = 0; k < plan->located; k++) {
        int i = plan->located_at[k];
        r->reached[i] = crossed[i] != 0 && fabs(seen[i]) <= BAND * r->band[k];
        near |= r->reached[i];
    }
    if (!near) {
        return;
    }
    look_ahead(r);
    for (int k = 0; k < plan->located; k++) {
        int i = plan->located_at[k];
        double change = roots[i] - seen[i];
        int back = (change > 0.0 && crossed[i] < 0) || (change < 0.0 && crossed[i] > 0);
        if (r->reached[i] && back && !(fabs(change) <= FLAT * r->band[k])) {
            r->released[i] = BEYOND;
        }
    }
    look(r);
}

/* The discrete equations, once, with the present modes; 0 or AC_FAILED. */
static int follow(ac_run *r)
{
    const ac_plan *plan = r->plan;
    if (plan->unknowns == 0) {
        return 0;
    }
    ac_solved(r);
    r->values_d[0] = NAN;
    (void)ac_point(r, plan->update, r->values_d);
    for (int i = 0; i < plan->unknowns; i++) {
        if (!isfinite(r->values_d[i])) {
            return ac_say(r, AC_FAILED, "%s is not a number at time %.12g s (%s)", plan->discrete_name[i],
                          r->event_time, plan->discrete_place[i]);
        }
    }
    put(r, r->d, r->values_d, plan->unknowns);
    return 0;
}

/* One pass over blocks, modes and discrete equations. */
static int passed(ac_run *r, int which)
{
    const ac_plan *plan = r->plan;
    int only = -1;
    int code = ac_settled(r);
    code = code == 0 ? judged(r) : code;
    if (code != 0) {
        ac_keep(r);
        return code;
    }
    for (int i = 0; i < plan->modes; i++) {
        if (r->wanted[i] != r->m[i]) {
            r->disputed[i] = 1;
            r->model.settled = 0;
            only = only < 0 || which == LAST ? i : only;
            if (which == ALL) {
                r->m[i] = r->wanted[i];
            }
        }
    }
    if (only >= 0) {
        r->m[only] = r->wanted[only];
    }
    code = follow(r);
    if (code != 0) {
        ac_keep(r);
    }
    return code;
}

static int agree(const ac_run *r, const double *m, const double *d)
{
    return memcmp(r->m, m, bytes(r->plan->modes)) == 0 && ac_same(r->d, d, r->plan->frozen);
}

static void note(const ac_run *r, double *m, double *d)
{
    memcpy(m, r->m, bytes(r->plan->modes));
    memcpy(d, r->d, bytes(r->plan->frozen));
}

static void back(ac_run *r, const double *m, const double *d)
{
    put(r, r->m, m, r->plan->modes);
    put(r, r->d, d, r->plan->frozen);
}

static int iterated(ac_run *r, int which)
{
    int most = ITERATIONS + (which != ALL ? PER_MODE * r->plan->modes : 0);
    int anchor = 1;
    note(r, r->seen_m, r->seen_d);
    for (int i = 1; i <= most; i++) {
        note(r, r->old_m, r->old_d);
        if (passed(r, which) != 0) {
            return BROKEN;
        }
        if (agree(r, r->old_m, r->old_d)) {
            return SETTLED;
        }
        if (agree(r, r->seen_m, r->seen_d)) {
            return CIRCLE;
        }
        if (i == anchor) { /* whatever repeats is met again after twice as many steps at most (Brent 1980) */
            anchor *= 2;
            note(r, r->seen_m, r->seen_d);
        }
    }
    return CIRCLE;
}

/* Whether everything agrees with the modes in doubt as they are chosen, once the rest has followed. */
static int is_consistent(ac_run *r, const int *which, int count, int choice)
{
    for (int i = 0; i < FOLLOWING; i++) { /* the discrete values of these modes, before the modes are judged */
        memcpy(r->old_d, r->d, bytes(r->plan->frozen));
        if (follow(r) != 0) {
            return 0;
        }
        if (ac_same(r->old_d, r->d, r->plan->frozen)) {
            break;
        }
    }
    for (int i = 0; i < ITERATIONS; i++) {
        note(r, r->old_m, r->old_d);
        if (passed(r, ALL) != 0) {
            return 0;
        }
        for (int k = 0; k < count; k++) {
            if (r->m[which[k]] != (double)(choice >> (count - 1 - k) & 1)) {
                return 0;
            }
        }
        if (agree(r, r->old_m, r->old_d)) {
            return 1;
        }
    }
    return 0;
}

/* Every assignment of the modes in doubt, from where the circle was left; whether one is consistent. */
static int tried(ac_run *r)
{
    int which[TRIED];
    int count = 0;
    for (int i = 0; i < r->plan->modes; i++) {
        if (r->disputed[i] && count == TRIED) {
            return 0;
        }
        if (r->disputed[i]) {
            which[count++] = i;
        }
    }
    for (r->undecided = 0; r->undecided <= 1; r->undecided++) {
        for (int choice = 0; choice < 1 << count; choice++) {
            back(r, r->seen_m, r->seen_d);
            for (int k = 0; k < count; k++) {
                r->m[which[k]] = (double)(choice >> (count - 1 - k) & 1);
            }
            r->model.settled = 0;
            if (is_consistent(r, which, count, choice)) {
                return 1;
            }
        }
    }
    return 0;
}

static int circling(ac_run *r)
{
    const ac_plan *plan = r->plan;
    for (int i = 0; i < plan->modes; i++) {
        if (r->disputed[i]) {
            return ac_say(r, CIRCLING, "conditions switch back and forth at time %.12g s and do not settle: %s (%s)",
                          r->event_time, plan->crossing[i].text, plan->crossing[i].place);
        }
    }
    for (int i = 0; i < plan->unknowns; i++) {
        if (r->seen_d[i] != r->old_d[i] || plan->unknowns == 1) {
            return ac_say(r, AC_FAILED, "the event at time %.12g s does not end: %s changes again and again (%s)",
                          r->event_time, plan->discrete_name[i], plan->discrete_place[i]);
        }
    }
    return ac_say(r, AC_FAILED, "the event at time %.12g s does not end", r->event_time);
}

/* The inner loop. */
static int agreed(ac_run *r)
{
    static const int ways[3][2] = {{ALL, 0}, {ALL, 1}, {FIRST, 0}}; /* and whether rest at zero is undecided */
    const ac_plan *plan = r->plan;
    int found = SETTLED;
    if (plan->modes == 0 && plan->frozen == 0) {
        return ac_settled(r);
    }
    r->first[0] = '\0';
    memset(r->disputed, 0, (size_t)plan->modes * sizeof(int));
    note(r, r->start_m, r->start_d);
    for (int i = 0; i < 3; i++) {
        r->undecided = ways[i][1];
        found = iterated(r, ways[i][0]);
        r->undecided = 0;
        if (found == SETTLED) {
            return 0;
        }
        back(r, r->start_m, r->start_d);
    }
    if (found == BROKEN) {
        memcpy(r->message, r->first, sizeof r->message);
        return AC_FAILED;
    }
    int fine = tried(r);
    r->undecided = 0;
    if (!fine) {
        back(r, r->start_m, r->start_d);
        fine = iterated(r, LAST) == SETTLED;
    }
    return fine ? 0 : circling(r);
}

/* Notes checks and stops that are met, and resets states; whether any was reset, AC_FAILED where one is no number. */
static int acted(ac_run *r)
{
    const ac_plan *plan = r->plan;
    int n = plan->resets;
    int c = plan->checks;
    int any = 0;
    if (n + c + plan->stops == 0) {
        return 0;
    }
    double *values = r->found;
    ac_solved(r);
    (void)ac_point(r, plan->actions, values);
    for (int i = 0; i < c; i++) {
        if (values[2 * n + i] != 0.0 && values[2 * n + c + i] != 1.0) {
            r->fired[i] = 1.0;
        }
    }
    for (int i = 0; i < plan->stops; i++) {
        if (values[2 * (n + c) + i] != 0.0) {
            r->fired[c + i] = 1.0;
        }
    }
    for (int i = 0; i < n; i++) {
        const char *name = plan->state[plan->reset_state[i]].name;
        if (values[i] != 0.0 && !isfinite(values[n + i])) {
            return ac_say(r, AC_FAILED, "reinit(%s, ...) gives %.6g at time %.12g s", name, values[n + i],
                          r->event_time);
        }
        if (values[i] != 0.0) {
            r->event_x[plan->reset_state[i]] = values[n + i];
            any = 1;
        }
    }
    if (any) {
        ac_at(r, r->event_time, r->event_x);
    }
    return any;
}

/* Notes the instant, and gives crossed relations their new values. */
static int arrived(ac_run *r, const int *crossed)
{
    const ac_plan *plan = r->plan;
    r->anchored = 0;
    r->undecided = 0;
    for (int i = 0; i < plan->modes; i++) {
        r->crossed[i] = r->met[i] = crossed != NULL && crossed[i] != 0;
        r->released[i] = plan->whole[i];
    }
    if (crossed == NULL) {
        return 0;
    }
    int code = ac_settled(r);
    if (code != 0) {
        return code;
    }
    look(r);
    against(r, crossed);
    memcpy(r->event_roots, r->model.roots, bytes(plan->modes));
    r->anchored = plan->frozen > 0;
    for (int i = 0; i < plan->modes; i++) {
        if (crossed[i] != 0 && r->released[i] != BEYOND) {
            r->m[i] = (double)(plan->above[i] ? crossed[i] > 0 : crossed[i] < 0);
        }
    }
    r->model.settled = 0;
    return 0;
}

static int settled(ac_run *r, double time, double *x, const int *crossed)
{
    const ac_plan *plan = r->plan;
    memset(r->fired, 0, bytes(plan->checks + plan->stops));
    r->event_time = time;
    memcpy(r->event_x, x, bytes(plan->states));
    ac_at(r, time, x);
    int code = arrived(r, crossed);
    if (code != 0 || plan->frozen == 0) {
        return code != 0 ? code : agreed(r);
    }
    for (int i = 0; i < ITERATIONS; i++) {
        int again = r->anchored;
        code = agreed(r);
        if (code != 0) {
            return code;
        }
        r->anchored = 0;
        int reset = acted(r);
        if (reset < 0) {
            return reset;
        }
        again |= reset;
        memcpy(r->past, r->d + plan->unknowns, bytes(plan->memory));
        ac_remember(r);
        for (int k = 0; k < plan->memory; k++) {
            again |= plan->judged[k] && !ac_same(r->past + k, r->d + plan->unknowns + k, 1);
        }
        if (!again) {
            memcpy(x, r->event_x, bytes(plan->states));
            return 0;
        }
    }
    for (int k = 0; k < plan->memory; k++) {
        if (plan->judged[k] && !ac_same(r->past + k, r->d + plan->unknowns + k, 1)) {
            return ac_say(r, AC_FAILED, "the event at time %.12g s does not end: %s changed in each of %d iterations",
                          time, plan->memory_name[k], ITERATIONS);
        }
    }
    return ac_say(r, AC_FAILED, "the event at time %.12g s does not end: states are reset in each of %d iterations",
                  time, ITERATIONS);
}

/* `crossed` with what is zero at this instant and crosses next, into `disputed`; 0 if there is no more. */
static int crossing(ac_run *r, double time, const double *x, const int *crossed)
{
    const ac_plan *plan = r->plan;
    int any = 0;
    memcpy(r->event_x, x, bytes(plan->states));
    ac_at(r, time, x);
    (void)arrived(r, NULL);
    if (ac_settled(r) != 0 || judged(r) != 0) {
        return 0;
    }
    for (int i = 0; i < plan->modes; i++) {
        int known = crossed != NULL ? crossed[i] : 0;
        int more = known == 0 && r->reached[i] && r->wanted[i] != r->m[i];
        int rising = plan->above[i] == (r->wanted[i] != 0.0);
        r->disputed[i] = !more ? known : rising ? 1 : -1;
        any |= more;
    }
    return any;
}

/* Iterates to a fixed point at this instant; the states after it are in `x`. `crossed` marks the roots that brought
 * the solver here. Where modes go round in circles, what else is zero and about to cross has crossed, too. */
int ac_settle(ac_run *r, double time, double *x, const int *crossed)
{
    const ac_plan *plan = r->plan;
    memcpy(r->kept_m, r->m, bytes(plan->modes));
    memcpy(r->kept_d, r->d, bytes(plan->frozen));
    memcpy(r->kept_guess, r->model.guess, bytes(plan->guesses));
    int code = settled(r, time, x, crossed);
    if (code == CIRCLING && plan->frozen > 0) {
        memcpy(r->m, r->kept_m, bytes(plan->modes));
        memcpy(r->d, r->kept_d, bytes(plan->frozen));
        memcpy(r->model.guess, r->kept_guess, bytes(plan->guesses));
        if (crossing(r, time, x, crossed)) {
            code = settled(r, time, x, r->disputed);
        }
    }
    return code == CIRCLING ? AC_FAILED : code;
}
