/* The memory of a run: one place says how much of it there is and hands it out. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "acausal_host.h"

enum { FUNCTIONS = 7 };

typedef struct {
    double *numbers;
    int *ints;
    ac_long *longs;
    const double **arg;
    double **res;
    int used[5]; /* without memory only this is counted */
} ac_pool;

static double *numbers(ac_pool *pool, int count)
{
    double *start = pool->numbers != NULL ? pool->numbers + pool->used[0] : NULL;
    pool->used[0] += count;
    return start;
}

static int *ints(ac_pool *pool, int count)
{
    int *start = pool->ints != NULL ? pool->ints + pool->used[1] : NULL;
    pool->used[1] += count;
    return start;
}

static void function(ac_run *r, ac_pool *pool, ac_function *f, ac_entry entry)
{
    f->entry = entry;
    f->machine = NULL;
    f->self = NULL;
    f->arg = pool->arg != NULL ? pool->arg + pool->used[3] : NULL;
    f->res = pool->res != NULL ? pool->res + pool->used[4] : NULL;
    f->iw = r->iw;
    f->w = r->w;
    pool->used[3] += r->plan->sz_arg;
    pool->used[4] += r->plan->sz_res;
}

static void scratch(ac_run *r, ac_pool *pool)
{
    const ac_plan *plan = r->plan;
    r->iw = pool->longs != NULL ? pool->longs + pool->used[2] : NULL;
    pool->used[2] += plan->sz_iw;
    r->arg = pool->arg != NULL ? pool->arg + pool->used[3] : NULL;
    pool->used[3] += plan->sz_arg;
    r->res = pool->res != NULL ? pool->res + pool->used[4] : NULL;
    pool->used[4] += plan->sz_res;
    r->w = numbers(pool, plan->sz_w);
}

static void model(ac_run *r, ac_pool *pool)
{
    const ac_plan *plan = r->plan;
    ac_model *m = &r->model;
    ac_function *const functions[FUNCTIONS] = {&m->ode,    &m->jac,    &m->derivative, &m->events,
                                               &m->scales, &m->output, &m->assertions};
    const ac_entry entries[FUNCTIONS] = {plan->ode,    plan->jac,    plan->derivative, plan->events,
                                         plan->scales, plan->output, plan->conditions};
    m->states = plan->states;
    m->crossings = plan->modes;
    m->guesses = plan->guesses;
    m->outputs = plan->outputs;
    m->conditions = plan->assertions;
    m->entries = plan->entries;
    m->takes_solution = plan->takes_solution;
    m->t = numbers(pool, 1);
    m->x = numbers(pool, plan->states);
    m->guess = numbers(pool, plan->guesses);
    m->z = numbers(pool, plan->guesses);
    m->xdot = numbers(pool, plan->states);
    m->jacobian = numbers(pool, plan->entries);
    m->rate = numbers(pool, plan->states);
    m->roots = numbers(pool, plan->modes);
    m->sizes = numbers(pool, plan->modes);
    m->row = numbers(pool, plan->outputs);
    m->ok = numbers(pool, plan->assertions);
    for (int i = 0; i < FUNCTIONS; i++) {
        function(r, pool, functions[i], entries[i]);
    }
}

/* Where the functions read and write. */
static void connected(ac_run *r)
{
    ac_model *m = &r->model;
    ac_function *const functions[FUNCTIONS] = {&m->ode,    &m->jac,    &m->derivative, &m->events,
                                               &m->scales, &m->output, &m->assertions};
    double *const results[FUNCTIONS] = {m->xdot, m->jacobian, m->rate, m->roots, m->sizes, m->row, m->ok};
    for (int i = 0; i < FUNCTIONS; i++) {
        const double *const given[8] = {m->t, m->x, r->p, r->m, r->u, r->d,
                                      i == 0 || i == 2 || (i == 1 && !r->plan->takes_solution) ? m->guess : m->z,
                                      r->factors};
        memcpy(functions[i]->arg, given, sizeof given);
        functions[i]->res[0] = results[i];
    }
    m->ode.res[1] = m->z;
    if (r->plan->takes_solution) {
        m->jac.res[1] = m->rate;
    }
}

static void vectors(ac_run *r, ac_pool *pool)
{
    const ac_plan *plan = r->plan;
    int frozen = plan->frozen;
    int slots = plan->initial.slots > plan->dynamic.slots ? plan->initial.slots : plan->dynamic.slots;
    const struct {
        double **vector;
        int count;
    } all[] = {{&r->p, plan->parameters},
               {&r->given, plan->parameters},
               {&r->chosen, plan->parameters},
               {&r->u, plan->inputs + plan->delays},
               {&r->m, plan->modes},
               {&r->d, frozen},
               {&r->s, plan->starts},
               {&r->s_given, plan->starts},
               {&r->s_chosen, plan->starts},
               {&r->nominal, plan->states + plan->guesses},
               {&r->factors, plan->factors},
               {&r->values, slots > 2 * plan->modes ? slots : 2 * plan->modes},
               {&r->known, plan->widest},
               {&r->found, plan->widest},
               {&r->block, plan->largest * (10 * plan->largest + 17)},
               {&r->x, plan->states},
               {&r->before_x, plan->states},
               {&r->event_x, plan->states},
               {&r->event_roots, plan->modes},
               {&r->later, plan->states},
               {&r->wanted, plan->modes},
               {&r->start_m, plan->modes},
               {&r->start_d, frozen},
               {&r->old_m, plan->modes},
               {&r->old_d, frozen},
               {&r->seen_m, plan->modes},
               {&r->seen_d, frozen},
               {&r->was_m, plan->modes},
               {&r->was_d, frozen},
               {&r->before, frozen},
               {&r->past, frozen},
               {&r->values_d, frozen},
               {&r->seen_roots, 2 * plan->modes},
               {&r->kept_m, plan->modes},
               {&r->kept_d, frozen},
               {&r->kept_guess, plan->guesses},
               {&r->shift, plan->located},
               {&r->band, plan->located},
               {&r->reach, plan->located},
               {&r->probe, 2 * plan->states + plan->guesses},
               {&r->side, plan->modes},
               {&r->slack, plan->modes},
               {&r->row, plan->outputs},
               {&r->fired, plan->checks + plan->stops},
               {&r->sample_start, plan->samples},
               {&r->sample_interval, plan->samples},
               {&r->sample_count, plan->samples},
               {&r->instants, plan->instants},
               {&r->past_time, plan->past},
               {&r->past_samples, plan->past * 5 * plan->delays},
               {&r->past_now, 6 * plan->delays},
               {&r->past_x, plan->delays > 0 ? plan->states : 0}};
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        *all[i].vector = numbers(pool, all[i].count + 1);
    }
    r->pivots = ints(pool, plan->largest);
    r->crossed = ints(pool, plan->modes);
    r->met = ints(pool, plan->modes);
    r->released = ints(pool, plan->modes);
    r->disputed = ints(pool, plan->modes);
    r->reached = ints(pool, plan->modes);
    r->warned = ints(pool, plan->assertions + plan->checks);
}

static void solver(ac_run *r, ac_pool *pool)
{
    const ac_plan *plan = r->plan;
    ac_solver *s = &r->solver;
    s->model = &r->model;
    s->nominal = s->atol = r->nominal;
    s->jmap = plan->w_places;
    s->diagonal = plan->w_diagonal;
    s->lu.n = plan->states;
    s->lu.capacity = plan->capacity;
    s->lu.ap = plan->w_columns;
    s->lu.ai = plan->w_rows;
    s->lu.q = plan->w_order;
    r->step_numbers = numbers(pool, ac_doubles(plan->states, plan->modes, plan->guesses, plan->entries));
    r->step_ints = ints(pool, ac_ints(plan->modes));
    r->factor_numbers = numbers(pool, ac_lu_doubles(plan->states, plan->w_entries, plan->capacity));
    r->factor_ints = ints(pool, ac_lu_ints(plan->states, plan->capacity));
    s->error_failures = s->convergence_failures = pool->longs != NULL ? pool->longs + pool->used[2] : NULL;
    pool->used[2] += plan->states;
}

void ac_begin(ac_run *r)
{
    const ac_plan *plan = r->plan;
    ac_init(&r->solver, r->step_numbers, r->step_ints);
    ac_lu_init(&r->solver.lu, r->factor_numbers, r->factor_ints, plan->w_entries);
}

static void laid_out(ac_run *r, ac_pool *pool)
{
    scratch(r, pool);
    vectors(r, pool);
    model(r, pool);
    solver(r, pool);
}

void ac_memory(const ac_plan *plan, int size[5])
{
    ac_run r;
    ac_pool pool;
    memset(&r, 0, sizeof r);
    memset(&pool, 0, sizeof pool);
    r.plan = plan;
    laid_out(&r, &pool);
    memcpy(size, pool.used, sizeof pool.used);
}

void ac_attach(ac_run *r, const ac_plan *plan, double *numbers_of, int *ints_of, ac_long *longs, const double **arg,
               double **res, ac_series *inputs)
{
    ac_pool pool;
    memset(r, 0, sizeof *r);
    memset(&pool, 0, sizeof pool);
    r->plan = plan;
    r->input = inputs;
    pool.numbers = numbers_of;
    pool.ints = ints_of;
    pool.longs = longs;
    pool.arg = arg;
    pool.res = res;
    laid_out(r, &pool);
    connected(r);
    memset(numbers_of, 0, (size_t)pool.used[0] * sizeof(double));
    memset(ints_of, 0, (size_t)pool.used[1] * sizeof(int));
    for (int i = 0; i < plan->inputs; i++) {
        memset(&inputs[i], 0, sizeof inputs[i]);
    }
}

int ac_is_number_of(int type, int literals, double value)
{
    switch (type) {
    case AC_BOOLEAN:
        return value == 0.0 || value == 1.0;
    case AC_INTEGER:
        return value == floor(value);
    case AC_ENUMERATION:
        return value == floor(value) && value >= 1.0 && value <= (double)literals;
    default:
        return 1;
    }
}

const char *ac_wanted(int type)
{
    static const char *const wanted[4] = {"a finite number", "a whole number", "true or false", "one of its literals"};
    return wanted[type];
}

int ac_set(ac_run *r, int index, double value)
{
    const ac_tunable *t = &r->plan->tunable[index];
    if (!isfinite(value) || !ac_is_number_of(t->type, t->literals, value)) {
        return ac_say(r, AC_FAILED, "%.6g is no value for %s: it must be %s", value, t->name, ac_wanted(t->type));
    }
    if (t->is_start) {
        r->s_given[t->position] = value;
        r->s_chosen[t->position] = 1.0;
    } else {
        r->given[t->position] = value;
        r->chosen[t->position] = 1.0;
    }
    return 0;
}
