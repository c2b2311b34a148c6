/* The model's functions at a point. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "acausal_runtime.h"

int ac_call(const ac_function *f)
{
    if (f->entry != NULL) {
        return f->entry(f->arg, f->res, f->iw, f->w, 0);
    }
    if (f->machine != NULL) { /* neither: there is nothing to compute */
        f->machine(f->self);
    }
    return 0;
}

/* A sum of finite numbers is finite, unless it is too large for one: then they are looked at one by one. */
int ac_finite(const double *v, int n)
{
    double sum[4] = {0.0, 0.0, 0.0, 0.0};
    int i = 0;
    for (; i + 3 < n; i += 4) {
        sum[0] += v[i];
        sum[1] += v[i + 1];
        sum[2] += v[i + 2];
        sum[3] += v[i + 3];
    }
    for (; i < n; i++) {
        sum[0] += v[i];
    }
    int fine = isfinite(sum[0] + sum[1] + sum[2] + sum[3]);
    for (i = 0; !fine && i < n && isfinite(v[i]); i++) {
    }
    return fine || i == n;
}

static size_t bytes(int n)
{
    return (size_t)n * sizeof(double);
}

static double interpolated(ac_table *table, double t)
{
    const double *times = table->times;
    int low = table->at;
    if (!(times[low] <= t && t < times[low + 1])) {
        int high = table->count - 1; /* the last interval that begins at t or before it */
        for (low = 0; high - low > 1;) {
            int middle = low + (high - low) / 2;
            if (times[middle] <= t) {
                low = middle;
            } else {
                high = middle;
            }
        }
        table->at = low;
    }
    double share = (t - times[low]) / (times[low + 1] - times[low]);
    share = fmin(fmax(share, 0.0), 1.0);
    return table->values[low] + share * (table->values[low + 1] - table->values[low]);
}

static void fill(ac_model *m, double t)
{
    for (int i = 0; i < m->table_count; i++) {
        m->u[m->tables[i].position] = interpolated(&m->tables[i], t);
    }
    if (m->fill != NULL) {
        m->fill(m->owner, t);
    }
}

/* What depends on the time alone is known for the point that is placed. */
static void clocked(ac_model *m)
{
    if ((m->timed.entry != NULL || m->timed.machine != NULL) && m->timed_at != m->t[0]) {
        m->timed_at = m->t[0];
        (void)ac_call(&m->timed);
    }
}

void ac_model_at(ac_model *m, double t, const double *x)
{
    if (m->settled && m->t[0] == t && (m->states == 0 || memcmp(m->x, x, bytes(m->states)) == 0)) {
        return;
    }
    m->settled = 0;
    m->t[0] = t;
    if (m->states > 0) {
        memcpy(m->x, x, bytes(m->states));
    }
    fill(m, t);
}

/* Back to a point at which derivatives and blocks are known. */
void ac_known(ac_model *m, double t, const double *x, const double *f, const double *z)
{
    if (m->guesses == 0 || (m->settled && m->t[0] == t && memcmp(m->x, x, bytes(m->states)) == 0)) {
        return;
    }
    m->settled = 0;
    ac_model_at(m, t, x);
    memcpy(m->xdot, f, bytes(m->states));
    memcpy(m->z, z, bytes(m->guesses));
    memcpy(m->guess, z, bytes(m->guesses));
    m->settled = 1;
}

/* Solves the implicit blocks at the point that is placed. What they find is the next guess. */
int ac_blocks(ac_model *m)
{
    if (m->settled) {
        return 0;
    }
    m->evaluations++;
    clocked(m);
    if (m->states > 0) {
        m->xdot[0] = NAN;
    }
    if (m->guesses > 0) {
        m->z[0] = NAN;
    }
    if (ac_call(&m->ode) != 0 || !ac_finite(m->xdot, m->states) || !ac_finite(m->z, m->guesses)) {
        if (ac_finite(m->z, m->guesses) || m->rescue == NULL || m->rescue(m->owner, 0) != 0) {
            return AC_NOT_FINITE;
        }
    }
    if (m->guesses > 0) {
        memcpy(m->guess, m->z, bytes(m->guesses));
        m->settled = 1;
    }
    return 0;
}

/* Compiled functions of explicit models read `x` and write `f` where they are. */
static int direct(ac_model *m, double t, const double *x, double *f)
{
    m->t[0] = t;
    fill(m, t);
    m->evaluations++;
    clocked(m);
    m->ode.arg[1] = x;
    m->ode.res[0] = f;
    int code = m->ode.entry(m->ode.arg, m->ode.res, m->ode.iw, m->ode.w, 0);
    m->ode.arg[1] = m->x;
    m->ode.res[0] = m->xdot;
    if (code == 0 && (m->unchecked || ac_finite(f, m->states))) {
        return 0;
    }
    memcpy(m->x, x, bytes(m->states));
    return AC_NOT_FINITE;
}

int ac_slope(ac_model *m, double t, const double *x, double *f)
{
    if (m->ode.entry != NULL && m->guesses == 0 && m->states > 0) {
        return direct(m, t, x, f);
    }
    ac_model_at(m, t, x);
    int code = ac_blocks(m);
    if (code == 0 && m->states > 0) {
        memcpy(f, m->xdot, bytes(m->states));
    }
    return code;
}

int ac_matrix(ac_model *m, double t, const double *x)
{
    ac_model_at(m, t, x);
    m->jacobians++;
    if (m->entries == 0 && !m->exact_rate) { /* the derivative by time may come with the matrix */
        return 0;
    }
    if (m->takes_solution && m->guesses > 0 && ac_blocks(m) != 0) {
        return AC_NOT_FINITE;
    }
    clocked(m);
    (void)ac_call(&m->timed_slopes);
    if (m->entries > 0) {
        m->jacobian[0] = NAN;
    }
    if (ac_call(&m->jac) == 0 && ac_finite(m->jacobian, m->entries)) {
        return 0;
    }
    return m->guesses > 0 && m->rescue != NULL && m->rescue(m->owner, 1) == 0 ? 0 : AC_NOT_FINITE;
}

/* d xdot / d t, right after `ac_matrix` at this point: from its function, with the matrix, or by a difference over a
 * small part of `span` towards its end. */
int ac_rate(ac_model *m, double t, const double *x, const double *f, double span, double *rate)
{
    if (m->autonomous) {
        memset(rate, 0, bytes(m->states));
        return 0;
    }
    if (m->exact_rate) {
        if (m->exact_rate == 1) {
            ac_model_at(m, t, x);
            m->rate[0] = NAN;
            if (ac_call(&m->derivative) != 0) {
                return AC_NOT_FINITE;
            }
        }
        if (!ac_finite(m->rate, m->states)) {
            return AC_NOT_FINITE;
        }
        memcpy(rate, m->rate, bytes(m->states));
        return 0;
    }
    double delta = sqrt(2.2e-16 * fmax(1e-5, fabs(t)));
    delta = fmin(delta, 0.5 * span);
    double end = t + delta;
    delta = end - t;
    int code = delta > 0.0 ? ac_slope(m, end, x, rate) : AC_NOT_FINITE;
    for (int i = 0; code == 0 && i < m->states; i++) {
        rate[i] = (rate[i] - f[i]) / delta;
    }
    return code;
}

int ac_roots(ac_model *m, double t, const double *x, double *g)
{
    ac_model_at(m, t, x);
    if (m->guesses > 0 && !m->free_roots && ac_blocks(m) != 0) {
        return AC_NOT_FINITE;
    }
    m->roots[0] = NAN;
    int code = ac_call(&m->events) != 0 ? AC_NOT_FINITE : 0;
    memcpy(g, m->roots, bytes(m->crossings));
    return code;
}

int ac_row(ac_model *m, double t, const double *x, double *row)
{
    ac_model_at(m, t, x);
    int fine = m->guesses > 0 ? ac_blocks(m) == 0 : 1;
    if (m->outputs > 0) {
        m->row[0] = NAN;
        clocked(m);
        fine = ac_call(&m->output) == 0 && fine && ac_finite(m->row, m->outputs);
        memcpy(row, m->row, bytes(m->outputs));
    }
    if (!fine) {
        return AC_ROW_NOT_FINITE;
    }
    if (m->conditions > 0) {
        m->ok[0] = NAN;
        if (ac_call(&m->assertions) != 0) {
            return AC_VIOLATED;
        }
        for (int i = 0; i < m->conditions; i++) {
            if (m->ok[i] != 1.0) {
                return AC_VIOLATED;
            }
        }
    }
    return 0;
}
