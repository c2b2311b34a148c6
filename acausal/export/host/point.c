/* The model at a point: its functions, the solution of its blocks, and values that agree. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "acausal_host.h"

/* Evaluates a function of (t, x, p, m, u, d, z) and, where it takes them, start values, at the present point. */
int ac_point(ac_run *r, ac_entry entry, double *result)
{
    const ac_model *m = &r->model;
    const double *const given[8] = {m->t, m->x, r->p, r->m, r->u, r->d, m->z, r->s};
    if (entry == NULL) {
        return 0;
    }
    for (int i = 0; i < 8; i++) {
        r->arg[i] = given[i];
    }
    r->res[0] = result;
    return entry(r->arg, r->res, r->iw, r->w, 0);
}

void ac_at(ac_run *r, double time, const double *x)
{
    ac_model *m = &r->model;
    m->settled = 0;
    m->t[0] = time;
    if (x != m->x) {
        memcpy(m->x, x, (size_t)m->states * sizeof(double));
    }
    if (m->fill != NULL) {
        m->fill(m->owner, time);
    }
}

/* Derivatives and solutions of blocks by the robust function; 0 where they are finite. */
static int robust(ac_run *r)
{
    ac_model *m = &r->model;
    const double *const given[7] = {m->t, m->x, r->p, r->m, r->u, r->d, m->guess};
    ac_entry entry = r->plan->robust != NULL ? r->plan->robust : r->plan->ode;
    for (int i = 0; i < 7; i++) {
        r->arg[i] = given[i];
    }
    r->res[0] = m->xdot;
    r->res[1] = m->z;
    int code = entry(r->arg, r->res, r->iw, r->w, 0);
    return code != 0 || !ac_finite(m->xdot, m->states) || !ac_finite(m->z, m->guesses);
}

/* Slopes by differences of the robust function: for points at which a block is singular. */
static int differences(ac_run *r)
{
    const ac_plan *plan = r->plan;
    ac_model *m = &r->model;
    double *rates = r->probe;
    double *x = rates + plan->states;
    double *z = x + plan->states;
    int code = robust(r);
    memcpy(rates, m->xdot, (size_t)plan->states * sizeof(double));
    memcpy(x, m->x, (size_t)plan->states * sizeof(double));
    memcpy(z, m->z, (size_t)plan->guesses * sizeof(double));
    for (int j = 0, p = 0; code == 0 && j < plan->states; j++) {
        double moved = x[j] + 1e-7 * fmax(fabs(x[j]), r->nominal[j]);
        m->x[j] = moved;
        code = robust(r);
        m->x[j] = x[j];
        for (; p < plan->entries && plan->w_places[p] < plan->w_columns[j + 1]; p++) {
            int row = plan->w_rows[plan->w_places[p]];
            m->jacobian[p] = (m->xdot[row] - rates[row]) / (moved - x[j]);
        }
    }
    if (code == 0 && plan->exact_rate != 0) {
        double time = m->t[0];
        m->t[0] = time + 1e-7 * fmax(1e-3, fabs(time));
        code = robust(r);
        for (int i = 0; i < plan->states; i++) {
            m->rate[i] = (m->xdot[i] - rates[i]) / (m->t[0] - time);
        }
        m->t[0] = time;
    }
    memcpy(m->xdot, rates, (size_t)plan->states * sizeof(double));
    memcpy(m->z, z, (size_t)plan->guesses * sizeof(double));
    return code;
}

/* The running program from the present point on. */
static int walked(ac_run *r)
{
    const ac_plan *plan = r->plan;
    const struct {
        const double *from;
        int count;
    } groups[6] = {{r->model.t, 1},       {r->model.x, plan->states},                 {r->p, plan->parameters},
                   {r->m, plan->modes},   {r->u, plan->inputs + plan->delays},        {r->d, plan->frozen}};
    double *to = r->values;
    for (int i = 0; i < 6; i++) {
        memcpy(to, groups[i].from, (size_t)groups[i].count * sizeof(double));
        to += groups[i].count;
    }
    return ac_walk(r, &plan->dynamic, r->model.guess, 0);
}

/* Derivatives (0) or slopes (1) where the functions for integrators give no numbers. */
int ac_rescue(void *owner, int what)
{
    ac_run *r = owner;
    const ac_plan *plan = r->plan;
    if (what != 0) {
        return differences(r);
    }
    if (plan->robust != NULL && robust(r) == 0) {
        return 0; /* without it that has been tried */
    }
    if (walked(r) != 0) {
        return 1;
    }
    for (int i = 0; i < plan->guesses; i++) {
        r->model.z[i] = r->values[plan->dynamic_z[i]];
    }
    for (int i = 0; i < plan->states; i++) {
        r->model.xdot[i] = r->values[plan->dynamic_xdot[i]];
    }
    return 0;
}

/* Derivatives and solutions of blocks at the present point; 1 where all are finite. What was found is the next
 * guess. */
int ac_evaluate(ac_run *r)
{
    ac_model *m = &r->model;
    if (m->states > 0) {
        m->xdot[0] = NAN;
    }
    if (m->guesses > 0) {
        m->z[0] = NAN;
    }
    m->evaluations++;
    int fine = ac_call(&m->ode) == 0;
    int solved = ac_finite(m->z, m->guesses);
    if (!solved && ac_rescue(r, 0) == 0) {
        fine = solved = 1;
    }
    if (m->guesses > 0) {
        m->settled = 1;
        if (solved) {
            memcpy(m->guess, m->z, (size_t)m->guesses * sizeof(double));
        }
    }
    return fine && solved && ac_finite(m->xdot, m->states);
}

void ac_solved(ac_run *r)
{
    if (r->model.guesses > 0 && !r->model.settled) {
        (void)ac_evaluate(r);
    }
}

void ac_rates(ac_run *r)
{
    if (r->model.guesses == 0 || !r->model.settled) {
        (void)ac_evaluate(r);
    }
}

/* Makes sure that the blocks are solved here, with the robust solver if need be; else says what fails. */
int ac_settled(ac_run *r)
{
    ac_model *m = &r->model;
    if (ac_evaluate(r)) {
        return 0;
    }
    int code = walked(r);
    if (code != 0) {
        return code;
    }
    for (int i = 0; i < m->guesses; i++) {
        m->guess[i] = r->values[r->plan->dynamic_z[i]];
    }
    if (ac_evaluate(r)) {
        return 0;
    }
    memcpy(m->z, m->guess, (size_t)m->guesses * sizeof(double));
    for (int i = 0; i < m->states; i++) {
        m->xdot[i] = r->values[r->plan->dynamic_xdot[i]];
    }
    return 0;
}

/* Equal to 1e-9: discrete numbers that come from an iteration differ by rounding. */
int ac_same(const double *a, const double *b, int n)
{
    for (int i = 0; i < n; i++) {
        if (!(a[i] == b[i] || fabs(a[i] - b[i]) <= 1e-9 * fmax(fabs(a[i]), fabs(b[i])))) {
            return 0;
        }
    }
    return 1;
}

/* What the relations say by their roots alone. */
void ac_literal(const ac_plan *plan, const double *roots, double *modes)
{
    for (int i = 0; i < plan->modes; i++) {
        int positive = plan->above[i] ? roots[i] > 0.0 : -roots[i] > 0.0;
        modes[i] = (double)(roots[i] == 0.0 ? plan->at_zero[i] : positive);
    }
}
