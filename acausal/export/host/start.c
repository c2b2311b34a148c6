/* The initial problem: parameters, start values, all unknowns at the start, and modes and discrete values that agree
 * with them. Tried in turn, each bounded: from the modes that the start values suggest, all conditions updated
 * together; the same from all false; then both again, changing only the first condition that disagrees (Murty 1974). */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "acausal_host.h"

#define ROUNDING 1e-12
#define CHECKED 1e-6

enum { ITERATIONS = 50, PER_MODE = 4, DELAY_PASSES = 50 };

static size_t bytes(int n)
{
    return (size_t)n * sizeof(double);
}

int ac_parameters(ac_run *r)
{
    const ac_plan *plan = r->plan;
    (void)ac_from(r, plan->parameters_of, r->given, r->chosen, r->p, NULL);
    for (int i = 0; i < plan->parameters; i++) {
        if (plan->parameter_needed[i] && !isfinite(r->p[i])) {
            return ac_say(r, AC_FAILED, "parameter %s is %s (%s)", plan->parameter_name[i],
                          isnan(r->p[i]) ? "not a number" : "infinite", plan->parameter_place[i]);
        }
    }
    (void)ac_from(r, plan->factors_of, r->p, NULL, r->factors, NULL);
    return 0;
}

static void nominals(ac_run *r)
{
    const ac_plan *plan = r->plan;
    (void)ac_from(r, plan->nominals_of, r->p, NULL, r->nominal, r->nominal + plan->states);
    for (int i = 0; i < plan->states + plan->guesses; i++) {
        if (!(isfinite(r->nominal[i]) && r->nominal[i] > 0.0)) {
            r->nominal[i] = 1.0;
        }
    }
}

static int inputs(ac_run *r)
{
    const ac_plan *plan = r->plan;
    (void)ac_from(r, plan->inputs_of, r->p, NULL, r->u, NULL);
    for (int i = 0; i < plan->inputs; i++) {
        if (r->input[i].given && r->input[i].count == 0) {
            r->u[i] = r->input[i].constant;
        }
        if (r->input[i].count == 0 && !isfinite(r->u[i])) {
            return ac_say(r, AC_FAILED, "input %s has no value", plan->input[i].name);
        }
        if (plan->input[i].type != AC_REAL && r->input[i].count > 0) {
            return ac_say(r, AC_FAILED, "input %s is no Real: only a constant can be given for it", plan->input[i].name);
        }
        if (r->input[i].count == 0 && !ac_is_number_of(plan->input[i].type, plan->input[i].literals, r->u[i])) {
            return ac_say(r, AC_FAILED, "%.6g is no value for input %s: it must be %s", r->u[i], plan->input[i].name,
                          ac_wanted(plan->input[i].type));
        }
    }
    memset(r->u + plan->inputs, 0, bytes(plan->delays));
    if (r->model.fill != NULL) {
        r->model.fill(r->model.owner, r->model.t[0]);
    }
    return 0;
}

/* Modes and frozen values with every variable at its start value. */
static void suggested(ac_run *r)
{
    const ac_plan *plan = r->plan;
    r->arg[0] = r->model.t;
    r->arg[1] = r->p;
    r->arg[2] = r->u;
    r->arg[3] = r->s;
    r->res[0] = r->event_roots;
    if (plan->start_roots != NULL) {
        (void)plan->start_roots(r->arg, r->res, r->iw, r->w, 0);
    }
    for (int i = 0; i < plan->modes; i++) {
        if (isnan(r->event_roots[i])) {
            r->event_roots[i] = 0.0;
        }
    }
    ac_literal(plan, r->event_roots, r->start_m);
    for (int i = 0; i < plan->frozen; i++) {
        int from = plan->suggested[i];
        r->start_d[i] = from >= 0 ? r->s[from] : from == -2 ? 1.0 : 0.0;
    }
}

/* The point of the running system that the walked values are. */
static void placed(ac_run *r)
{
    const ac_plan *plan = r->plan;
    for (int i = 0; i < plan->states; i++) {
        r->model.x[i] = r->values[plan->initial_x[i]];
    }
    for (int i = 0; i < plan->parameters; i++) {
        r->p[i] = r->values[plan->initial_p[i]];
    }
    for (int i = 0; i < plan->guesses; i++) {
        r->model.z[i] = plan->initial_z[i] >= 0 ? r->values[plan->initial_z[i]] : 0.0;
    }
    r->model.settled = 1; /* z is the solution */
}

/* All values with the present modes and frozen values. */
static int solve(ac_run *r)
{
    const ac_plan *plan = r->plan;
    const struct {
        const double *from;
        int count;
    } groups[6] = {{r->model.t, 1},       {r->p, plan->parameters}, {r->m, plan->modes},
                   {r->u, plan->inputs + plan->delays}, {r->d, plan->frozen}, {r->s, plan->starts}};
    for (int pass = 0; pass < (plan->delays > 0 ? DELAY_PASSES : 1); pass++) {
        double *to = r->values;
        for (int i = 0; i < 6; i++) {
            memcpy(to, groups[i].from, bytes(groups[i].count));
            to += groups[i].count;
        }
        int code = ac_walk(r, &plan->initial, r->s, 1);
        if (code != 0) {
            return code;
        }
        placed(r);
        if (plan->delays == 0) {
            return 0;
        }
        double *delayed = r->u + plan->inputs;
        int agree = 1;
        ac_delayed(r, r->past_now);
        for (int i = 0; i < plan->delays; i++) {
            agree = agree && fabs(delayed[i] - r->past_now[i]) <= 1e-12 * fabs(r->past_now[i]);
            delayed[i] = r->past_now[i];
        }
        if (agree) {
            return 0;
        }
    }
    return ac_say(r, AC_FAILED, "the initial values of delayed expressions do not settle");
}

/* The modes that the solution asks for, into `wanted`; with them the frozen values, into `values_d`. */
static void asked(ac_run *r, int one_by_one)
{
    const ac_plan *plan = r->plan;
    int kept = 0;
    (void)ac_call(&r->model.events);
    (void)ac_call(&r->model.scales);
    ac_literal(plan, r->model.roots, r->wanted);
    for (int i = 0; i < plan->modes; i++) {
        double root = r->model.roots[i];
        int rounded = fabs(root) <= ROUNDING * r->model.sizes[i] && root != 0.0;
        if (rounded || (one_by_one && kept)) {
            r->wanted[i] = r->m[i];
        }
        kept |= r->wanted[i] != r->m[i];
    }
    memcpy(r->values_d, r->d, bytes(plan->frozen));
    if (plan->start_discrete != NULL && plan->unknowns + plan->memory > 0) {
        memcpy(r->old_m, r->m, bytes(plan->modes));
        memcpy(r->m, r->wanted, bytes(plan->modes));
        (void)ac_point(r, plan->start_discrete, r->values_d);
        memcpy(r->m, r->old_m, bytes(plan->modes));
    }
}

static int agree(const ac_run *r, const double *m, const double *d)
{
    const ac_plan *plan = r->plan;
    return memcmp(r->m, m, bytes(plan->modes)) == 0 && ac_same(r->d, d, plan->frozen);
}

/* From `m` and `d` on: 0 where they settle, 1 where they go round in circles, or an error. */
static int searched(ac_run *r, int one_by_one)
{
    const ac_plan *plan = r->plan;
    int most = ITERATIONS + (one_by_one ? PER_MODE * plan->modes : 0);
    int anchor = 1;
    memcpy(r->seen_m, r->m, bytes(plan->modes));
    memcpy(r->seen_d, r->d, bytes(plan->frozen));
    for (int i = 1; i <= most; i++) {
        int code = solve(r);
        if (code != 0) {
            return code;
        }
        asked(r, one_by_one);
        if (agree(r, r->wanted, r->values_d)) {
            return 0;
        }
        memcpy(r->m, r->wanted, bytes(plan->modes));
        memcpy(r->d, r->values_d, bytes(plan->frozen));
        if (agree(r, r->seen_m, r->seen_d)) {
            return 1;
        }
        if (i == anchor) { /* whatever repeats is met again after twice as many steps at most (Brent 1980) */
            anchor *= 2;
            memcpy(r->seen_m, r->m, bytes(plan->modes));
            memcpy(r->seen_d, r->d, bytes(plan->frozen));
        }
    }
    return 1;
}

static int consistent(ac_run *r)
{
    const ac_plan *plan = r->plan;
    int circle = 0;
    int code = 0;
    r->first[0] = '\0';
    suggested(r);
    for (int attempt = 0; attempt < 4; attempt++) {
        memcpy(r->m, r->start_m, bytes(plan->modes));
        memcpy(r->d, r->start_d, bytes(plan->frozen));
        if (attempt % 2 == 1) {
            memset(r->m, 0, bytes(plan->modes));
        }
        code = searched(r, attempt >= 2);
        if (code == 0 || (plan->modes == 0 && plan->frozen == 0)) {
            return code;
        }
        if (code < 0) {
            ac_keep(r);
        } else {
            circle = 1;
        }
        (void)ac_parameters(r); /* as they were */
    }
    if (!circle) {
        memcpy(r->message, r->first, sizeof r->message);
        return AC_FAILED;
    }
    int worst = 0;
    for (int i = plan->modes - 1; i >= 0; i--) {
        worst = r->wanted[i] != r->seen_m[i] ? i : worst;
    }
    return plan->modes == 0
               ? ac_say(r, AC_FAILED, "no consistent initial values of the discrete variables")
               : ac_say(r, AC_FAILED, "no consistent initial modes: conditions switch back and forth, among them %s (%s)",
                        plan->crossing[worst].text, plan->crossing[worst].place);
}

static int redundant(ac_run *r)
{
    const ac_plan *plan = r->plan;
    double *value = r->found;
    double *size = value + plan->redundant;
    for (int i = 0; i < plan->redundant_reads; i++) {
        r->known[i] = r->values[plan->redundant_read[i]];
    }
    (void)ac_from(r, plan->redundancy, r->known, NULL, value, size);
    for (int i = 0; i < plan->redundant; i++) {
        if (!(fabs(value[i]) <= CHECKED * fmax(size[i], 1e-300))) {
            return ac_say(r, AC_FAILED, "the initial values contradict %s, which is off by %.6g",
                          plan->redundant_text[i], value[i]);
        }
    }
    return 0;
}

/* Parameters, modes, discrete values, states (into `x`) and guesses at the start. */
int ac_start_values(ac_run *r, double time)
{
    const ac_plan *plan = r->plan;
    r->model.t[0] = time;
    r->model.settled = 0;
    int code = ac_parameters(r);
    if (code != 0) {
        return code;
    }
    nominals(r);
    (void)ac_from(r, plan->starts_of, r->p, NULL, r->s, NULL);
    for (int i = 0; i < plan->starts; i++) {
        r->s[i] = r->s_chosen[i] != 0.0 ? r->s_given[i] : r->s[i];
    }
    code = inputs(r);
    code = code == 0 ? consistent(r) : code;
    code = code == 0 ? redundant(r) : code;
    if (code != 0) {
        return code;
    }
    for (int i = 0; i < plan->parameters; i++) {
        if (plan->free_p[i]) {
            r->given[i] = r->values[plan->initial_p[i]];
            r->chosen[i] = 1.0;
        }
    }
    memcpy(r->x, r->model.x, bytes(plan->states));
    memcpy(r->model.guess, r->model.z, bytes(plan->guesses));
    code = ac_parameters(r);
    for (int i = 0; i < plan->parameters; i++) { /* the next run begins from the same */
        r->chosen[i] = plan->free_p[i] ? 0.0 : r->chosen[i];
    }
    nominals(r);
    return code;
}
