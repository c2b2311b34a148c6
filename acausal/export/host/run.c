/* A run: from one output time to the next, stopping at events. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "acausal_host.h"

#define AHEAD 1e-9
#define HELD 1e4
#define ZENO_SHARE 1e-6
#define RESOLVED 1e-8

enum { BUDGET = 1000000000, SHRINKING = 24 };

static size_t bytes(int n)
{
    return (size_t)n * sizeof(double);
}

void ac_defaults(const ac_plan *plan, ac_settings *settings)
{
    memset(settings, 0, sizeof *settings);
    settings->start_time = plan->start_time;
    settings->stop_time = plan->stop_time;
    settings->interval = plan->interval;
    settings->step = plan->step;
    settings->method = plan->method;
    settings->locate = plan->locate;
    settings->max_steps = 1000000000000;
}

/* A condition that should hold does not; the first time this is passed on. */
static void warned(ac_run *r, int i, double time, const ac_notice *notice)
{
    if (!r->warned[i] && r->settings.warn != NULL) {
        r->settings.warn(r->settings.owner, time, notice);
    }
    r->warnings += !r->warned[i];
    r->warned[i] = 1;
}

/* Explicit steps that are too long let states grow without bound. */
static int advised(ac_run *r, int code)
{
    static const char *const text = "; the step of %g s may exceed the stability limit of the explicit method: "
                                    "try a shorter step, or the solver lieuler or rosenbrock; `acausal eigen` prints the limits";
    size_t length = strlen(r->message);
    if (r->plan->states > 0 && r->solver.method >= AC_EULER && r->solver.method <= AC_DOPRI5 && length < sizeof r->message) {
        (void)snprintf(r->message + length, sizeof r->message - length, text, r->settings.step);
    }
    return code;
}

/* Evaluates the outputs, looks at assertions and hands the row over. */
int ac_record(ac_run *r, double time, const double *x)
{
    const ac_plan *plan = r->plan;
    ac_model *m = &r->model;
    ac_at(r, time, x);
    ac_solved(r);
    if (plan->outputs > 0) {
        (void)ac_call(&m->output);
    }
    if (!ac_finite(m->row, plan->outputs)) {
        int code = ac_settled(r);
        if (code != 0) {
            return time > r->settings.start_time ? advised(r, code) : code;
        }
        (void)ac_call(&m->output);
        for (int i = 0; i < plan->outputs; i++) {
            if (!isfinite(m->row[i])) {
                return ac_say(r, AC_FAILED, "%s is %s at time %.12g s", plan->variable[i].name,
                              isnan(m->row[i]) ? "not a number" : "infinite", time);
            }
        }
    }
    r->recorded = 1;
    r->recorded_time = time;
    if (r->settings.row != NULL && r->settings.row(r->settings.owner, time, m->row) != 0) {
        return ac_say(r, AC_STOPPED, "the row at time %.12g s could not be taken", time);
    }
    if (plan->assertions > 0) {
        (void)ac_call(&m->assertions);
    }
    for (int i = 0; i < plan->assertions; i++) {
        const ac_notice *notice = &plan->assertion[i];
        if (m->ok[i] == 1.0) {
            continue;
        }
        if (!notice->warning) {
            return ac_say(r, AC_FAILED, "%s (at time %.12g s; %s)", notice->text, time, notice->place);
        }
        warned(r, i, time, notice);
    }
    return 0;
}

/* Begins the integrator at the present point. */
static int restarted(ac_run *r)
{
    ac_at(r, r->time, r->x);
    if (ac_keep_past(r, r->ahead) != 0) {
        return AC_FAILED;
    }
    r->next = ac_upcoming(r, r->time);
    ac_at(r, r->time, r->x);
    ac_hold(r, HELD * r->ahead);
    r->model.settled = 0;
    int code = ac_restart(&r->solver, r->time, r->x, r->side, r->slack);
    return code != 0 ? ac_say(r, AC_FAILED, "a condition of an event is not a number at time %.12g s", r->time) : 0;
}

/* Acts on what the event met: checks that are violated, and the model's own end. */
static int met(ac_run *r)
{
    const ac_plan *plan = r->plan;
    for (int i = 0; i < plan->checks; i++) {
        const ac_notice *notice = &plan->check[i];
        if (r->fired[i] == 0.0) {
            continue;
        }
        if (!notice->warning) {
            return ac_say(r, AC_FAILED, "%s (at time %.12g s; %s)", notice->text, r->time, notice->place);
        }
        warned(r, plan->assertions + i, r->time, notice);
    }
    for (int i = 0; i < plan->stops && !r->ended; i++) {
        if (r->fired[plan->checks + i] != 0.0) {
            r->ended = 1;
            (void)ac_say(r, 0, "%s (at time %.12g s; %s)", plan->stop[i].text, r->time, plan->stop[i].place);
        }
    }
    return 0;
}

static void note(ac_run *r)
{
    memcpy(r->was_m, r->m, bytes(r->plan->modes));
    memcpy(r->was_d, r->d, bytes(r->plan->unknowns));
}

static int is_changed(const ac_run *r)
{
    return memcmp(r->was_m, r->m, bytes(r->plan->modes)) != 0 || memcmp(r->was_d, r->d, bytes(r->plan->unknowns)) != 0;
}

/* Acts, and ends the moment in which samples are true. */
static int closed(ac_run *r)
{
    const ac_plan *plan = r->plan;
    double *samples = r->d + plan->unknowns + plan->memory;
    int any = 0;
    int code = met(r);
    for (int i = 0; i < plan->samples; i++) {
        any |= samples[i] != 0.0;
    }
    if (code != 0 || !any) {
        return code;
    }
    note(r);
    ac_remember(r);
    memset(samples, 0, bytes(plan->samples));
    r->model.settled = 0;
    code = ac_settle(r, r->time, r->x, NULL);
    if (code == 0 && is_changed(r)) {
        code = ac_record(r, r->time, r->x);
    }
    return code == 0 ? met(r) : code;
}

/* The stop that was `count` stops before the last one. */
static double stop_before(const ac_run *r, int count)
{
    return r->recent[(r->stops_seen - 1 - count) % AC_ZENO];
}

/* Whether the time between stops goes to zero like a geometric series, and has all but got there. */
static int shrinks(const ac_run *r, double span)
{
    enum { PAIRS = SHRINKING - 2 };
    if (r->stops_seen < SHRINKING) {
        return 0;
    }
    double last = stop_before(r, 0) - stop_before(r, 2);
    double first = stop_before(r, PAIRS - 1) - stop_before(r, PAIRS + 1);
    if (!(last <= fmin(RESOLVED * fmin(span, 1.0), 1e-2 * first))) {
        return 0;
    }
    for (int i = 0; i + 1 < PAIRS; i++) {
        double later = stop_before(r, i) - stop_before(r, i + 2);
        if (!(later <= stop_before(r, i + 1) - stop_before(r, i + 3))) {
            return 0;
        }
    }
    return 1;
}

/* Events that accumulate (Zeno) end the run. */
static int guarded(ac_run *r, int happened)
{
    double span = r->settings.stop_time - r->settings.start_time;
    r->events += happened;
    r->recent[r->stops_seen % AC_ZENO] = r->time;
    r->stops_seen++;
    int dense = r->stops_seen >= AC_ZENO && r->time - stop_before(r, AC_ZENO - 1) <= ZENO_SHARE * span;
    if (!dense && !shrinks(r, span)) {
        return 0;
    }
    const ac_notice none = {"discrete changes", "", 0};
    const ac_notice *notice = &none;
    for (int i = r->plan->modes - 1; i >= 0; i--) {
        notice = r->was_m[i] != r->m[i] || r->crossed[i] != 0 ? &r->plan->crossing[i] : notice;
    }
    if (dense) {
        return ac_say(r, AC_FAILED, "events accumulate at time %.12g s: %d within %.3g s, the last by %s (%s)", r->time,
                      AC_ZENO, r->time - stop_before(r, AC_ZENO - 1), notice->text, notice->place);
    }
    return ac_say(r, AC_FAILED, "events accumulate at time %.12g s: they are only %.3g s apart, the last by %s (%s)",
                  r->time, r->time - stop_before(r, 1), notice->text, notice->place);
}

/* An event at the present time: what changes, both sides of it in the results, and the integrator anew. */
static int happened(ac_run *r, const int *crossed)
{
    const ac_plan *plan = r->plan;
    if (ac_is_reached(r->time, r->next)) {
        r->time = r->next;
    }
    note(r);
    if (!(r->recorded && r->recorded_time == r->time)) {
        int code = ac_record(r, r->time, r->x);
        if (code != 0) {
            return code;
        }
    }
    ac_at(r, r->time, r->x);
    if (ac_keep_past(r, r->ahead) != 0) {
        return AC_FAILED;
    }
    ac_remember(r);
    int due = ac_due(r, r->time, r->d + plan->unknowns + plan->memory);
    r->model.settled = 0;
    memcpy(r->before_x, r->x, bytes(plan->states));
    int code = ac_settle(r, r->time, r->x, crossed);
    int changed = code == 0 && (is_changed(r) || due || memcmp(r->before_x, r->x, bytes(plan->states)) != 0);
    if (code == 0 && changed) {
        code = ac_record(r, r->time, r->x);
    }
    code = code == 0 ? guarded(r, changed) : code;
    code = code == 0 ? closed(r) : code;
    return code == 0 ? restarted(r) : code;
}

static void fill(void *owner, double time)
{
    ac_run *r = owner;
    if (r->plan->delays > 0) {
        ac_past_fill(r, time);
    }
    for (int i = 0; i < r->plan->inputs; i++) {
        const ac_series *s = &r->input[i];
        if (s->count < 2) {
            continue;
        }
        int low = 0;
        int high = s->count - 1;
        while (high - low > 1) {
            int middle = low + (high - low) / 2;
            if (s->time[middle] <= time) {
                low = middle;
            } else {
                high = middle;
            }
        }
        double share = (time - s->time[low]) / (s->time[low + 1] - s->time[low]);
        share = fmin(fmax(share, 0.0), 1.0);
        r->u[i] = s->value[low] + share * (s->value[low + 1] - s->value[low]);
    }
}

static void begun(ac_run *r)
{
    const ac_settings *settings = &r->settings;
    ac_solver *s = &r->solver;
    ac_model *m = &r->model;
    double largest = fmax(fabs(settings->start_time), fabs(settings->stop_time));
    int moving = r->plan->delays > 0;
    for (int i = 0; i < r->plan->inputs; i++) {
        moving |= r->input[i].count > 1;
    }
    m->fill = moving ? fill : NULL;
    m->owner = r;
    m->rescue = r->plan->guesses > 0 ? ac_rescue : NULL;
    m->exact_rate = moving ? 0 : r->plan->exact_rate;
    m->autonomous = !moving && !r->plan->exact_rate;
    m->evaluations = m->jacobians = 0;
    s->method = settings->method;
    s->locate = settings->locate;
    s->rtol = 1e-6;
    s->min_step = 7e-15 * largest;
    s->sample = fmin(settings->interval, settings->stop_time - settings->start_time);
    s->step = settings->step;
    s->origin = settings->start_time;
    s->max_steps = settings->max_steps;
    s->clock = settings->clock;
    s->index = 0;
    s->lu.factored = 0;
    r->ahead = AHEAD * (settings->stop_time > settings->start_time ? settings->stop_time - settings->start_time : 1.0);
    r->past_first = r->past_count = 0;
    r->stops_seen = r->events = r->warnings = 0;
    r->ended = r->jumped = r->recorded = r->anchored = r->undecided = 0;
    r->longest = 0.0;
    r->message[0] = '\0';
    memset(r->warned, 0, (size_t)(r->plan->assertions + r->plan->checks) * sizeof(int));
    for (int k = 0; k < r->plan->located; k++) {
        r->band[k] = 0.1;
        r->shift[k] = 0.0;
    }
}

int ac_start(ac_run *r, const ac_settings *settings)
{
    const ac_plan *plan = r->plan;
    r->settings = *settings;
    r->time = settings->start_time;
    begun(r);
    int code = ac_start_values(r, r->time);
    if (code != 0) {
        return code;
    }
    ac_begin(r);
    code = ac_schedule(r, r->time);
    ac_at(r, r->time, r->x);
    code = code == 0 ? ac_settled(r) : code;
    code = code == 0 ? ac_keep_past(r, r->ahead) : code;
    if (code != 0) {
        return code;
    }
    ac_remember(r);
    if (plan->initial_phase >= 0) {
        r->d[plan->initial_phase] = 0.0;
    }
    (void)ac_due(r, r->time, r->d + plan->unknowns + plan->memory);
    r->model.settled = 0;
    code = ac_settle(r, r->time, r->x, NULL);
    code = code == 0 ? ac_record(r, r->time, r->x) : code;
    code = code == 0 ? closed(r) : code;
    return code == 0 ? restarted(r) : code;
}

static int failed(ac_run *r, int code)
{
    const ac_solver *s = &r->solver;
    const ac_model *m = &r->model;
    if (code == AC_NOT_FINITE || code == AC_SINGULAR) {
        int found = 0;
        ac_at(r, m->t[0], m->x);
        found = ac_settled(r);
        if (found != 0) {
            return advised(r, found);
        }
    }
    const char *why = code == AC_SINGULAR         ? "the matrix of an implicit step is singular"
                      : code == AC_TOO_MANY_STEPS ? "too many steps"
                      : code == AC_MEMORY         ? "the factors of a step's matrix need more memory than there is"
                                                  : "something is not a number inside a step";
    int worst = 0;
    for (int i = 1; i < m->states; i++) {
        worst = fabs(m->xdot[i]) > fabs(m->xdot[worst]) ? i : worst;
    }
    code = ac_say(r, code, "the integration stopped at time %.12g s: %s; state that changes most: %s", s->t0, why,
                  m->states > 0 ? r->plan->state[worst].name : "none");
    return code == AC_NOT_FINITE ? advised(r, code) : code;
}

static double output_time(const ac_settings *s, ac_long i, ac_long count)
{
    return i < count ? s->start_time + (double)i * s->interval : s->stop_time;
}

/* The event at the end, where the model asks for it. */
static int terminated(ac_run *r)
{
    const ac_plan *plan = r->plan;
    if (plan->terminal_phase < 0) {
        return 0;
    }
    ac_at(r, r->time, r->x);
    ac_remember(r);
    r->d[plan->terminal_phase] = 1.0;
    r->model.settled = 0;
    note(r);
    int code = ac_settle(r, r->time, r->x, NULL);
    if (code == 0 && is_changed(r)) {
        code = ac_record(r, r->time, r->x);
    }
    return code == 0 ? met(r) : code;
}

/* A row that the integrator's run-time wrote: it is taken, or looked at again where something is wrong with it. */
static int taken(ac_run *r, double time, int code)
{
    if (code == AC_VIOLATED || code == AC_ROW_NOT_FINITE) {
        memcpy(r->before_x, r->model.x, bytes(r->plan->states));
        return ac_record(r, time, r->before_x);
    }
    r->recorded = 1;
    r->recorded_time = time;
    if (r->settings.row != NULL && r->settings.row(r->settings.owner, time, r->row) != 0) {
        return ac_say(r, AC_STOPPED, "the row at time %.12g s could not be taken", time);
    }
    return 0;
}

/* Without states and located events there is nothing to integrate: to `limit`, with a row where it is an output
 * time. */
static int stepped(ac_run *r, double target, double limit, ac_long *i)
{
    r->time = limit;
    if (ac_is_reached(r->time, r->next)) {
        return happened(r, NULL);
    }
    ac_at(r, r->time, r->x);
    int code = ac_keep_past(r, r->ahead);
    *i += limit >= target;
    if (code != 0) {
        return code;
    }
    return limit >= target && !(r->recorded && r->recorded_time == target) ? ac_record(r, target, r->x) : 0;
}

/* The output times that lie in the last step, several of them where steps are long. */
static int caught_up(ac_run *r, ac_long *i, ac_long count)
{
    int code = 0;
    while (code == 0 && *i <= count) {
        double target = output_time(&r->settings, *i, count);
        int rows = 0;
        int found = ac_written(&r->solver, &target, 1, r->row, &rows);
        if (rows == 0) {
            break;
        }
        code = taken(r, target, found);
        (*i)++;
    }
    return code;
}

/* To the next event, or as far as the integrator goes at once; `i` counts the output times. */
static int swept(ac_run *r, ac_long *i, ac_long count)
{
    const ac_plan *plan = r->plan;
    ac_solver *s = &r->solver;
    double target = output_time(&r->settings, *i, count);
    double until = fmin(fmin(r->settings.stop_time, r->next), ac_piece(r, r->time));
    int rows = 0;
    if (plan->states == 0 && plan->located == 0) {
        return stepped(r, target, fmin(target, until), i);
    }
    double end = fmin(until, ac_kink(r, s->t));
    int code = ac_sweep(s, &target, target <= end ? 1 : 0, end, BUDGET, r->row, &rows);
    if (code < 0 && code != AC_ROW_NOT_FINITE) {
        return failed(r, code);
    }
    int problem = rows > 0 ? taken(r, target, code) : 0;
    *i += rows;
    problem = problem == 0 ? caught_up(r, i, count) : problem;
    if (problem != 0 || (code != AC_REACHED && code != AC_EVENT)) {
        return problem;
    }
    if (code != AC_EVENT && s->t < until) {
        return 0; /* a kink of an input */
    }
    memcpy(r->x, s->x, bytes(plan->states));
    r->time = s->t;
    if (code == AC_EVENT) {
        double left = s->clock != NULL ? s->clock() : 0.0;
        problem = happened(r, s->crossed);
        r->longest = s->clock != NULL ? fmax(r->longest, s->clock() - left + s->latest) : 0.0;
        return problem;
    }
    if (ac_is_reached(r->time, r->next)) {
        return happened(r, NULL);
    }
    ac_at(r, r->time, r->x);
    return ac_keep_past(r, r->ahead);
}

int ac_go(ac_run *r)
{
    const ac_settings *s = &r->settings;
    double span = s->stop_time - s->start_time;
    ac_long count = span > 0.0 ? (ac_long)ceil(span / s->interval * (1.0 - 1e-12)) : 0;
    int code = 0;
    ac_long i = 1;
    while (code == 0 && i <= count && !r->ended) {
        code = ac_is_reached(r->time, r->next) ? happened(r, NULL) : swept(r, &i, count);
    }
    code = code == 0 ? terminated(r) : code;
    r->longest = fmax(r->longest, r->solver.longest);
    return code == 0 && r->ended ? AC_ENDED : code;
}
