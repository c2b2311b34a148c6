/* Starting, stepping over a grid of output times, and stopping at events. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "acausal_runtime.h"

int ac_doubles(int n, int m, int z, int entries)
{
    return AC_DOUBLES(n, m, z, entries);
}

int ac_ints(int m)
{
    return m;
}

static double *take(double **from, int count)
{
    double *start = *from;
    *from += count;
    return start;
}

void ac_init(ac_solver *s, double *doubles, int *ints)
{
    const ac_model *m = s->model;
    int n = m->states;
    double **const vectors[] = {&s->x,  &s->x0, &s->x1,    &s->f0,    &s->f1,    &s->f_old, &s->k1,
                                &s->k2, &s->k3, &s->stage, &s->scale, &s->error, &s->influence};
    double **const roots[] = {&s->side, &s->slack, &s->slack0, &s->g_old, &s->g_new, &s->g_try, &s->g_mid};
    for (size_t i = 0; i < sizeof vectors / sizeof vectors[0]; i++) {
        *vectors[i] = take(&doubles, n);
    }
    s->k = take(&doubles, AC_MAX_STAGES * n);
    for (size_t i = 0; i < sizeof roots / sizeof roots[0]; i++) {
        *roots[i] = take(&doubles, m->crossings);
    }
    s->z1 = take(&doubles, m->guesses);
    s->z0 = take(&doubles, m->guesses);
    s->ratio = take(&doubles, m->entries + n); /* the last n: d xdot / d t */
    s->crossed = ints;
    for (int j = 0, p = 0; j < n; j++) { /* entries of J come by columns, as those of W do */
        for (; p < m->entries && s->jmap[p] < s->lu.ap[j + 1]; p++) {
            s->ratio[p] = s->nominal[j] / s->nominal[s->lu.ai[s->jmap[p]]];
        }
    }
    memset(s->influence, 0, (size_t)n * sizeof(double));
    s->steps = s->rejected = s->failures = 0;
    s->lu.searches = s->lu.repeats = 0;
    s->latest = s->longest = 0.0;
    s->have_step = 0;
    s->room = s->pending = 0;
}

void ac_interpolate(const ac_solver *s, double t, double *x)
{
    int n = s->model->states;
    if (t == s->t1) {
        memcpy(x, s->x1, (size_t)n * sizeof(double));
        return;
    }
    double theta = (t - s->t0) / (s->t1 - s->t0);
    double rest = 1.0 - theta;
    for (int i = 0; i < n; i++) {
        double inner = s->k1[i] + theta * (s->k2[i] + theta * s->k3[i]);
        x[i] = rest * s->x0[i] + theta * (s->x1[i] + rest * inner);
    }
}

int ac_restart(ac_solver *s, double t, const double *x, const double *side, const double *slack)
{
    ac_model *m = s->model;
    size_t bytes = (size_t)m->states * sizeof(double);
    s->t = s->t0 = s->t1 = t;
    m->settled = 0;
    if (m->states > 0) {
        memcpy(s->x, x, bytes);
        memcpy(s->x1, x, bytes);
    }
    s->have_step = s->have_f0 = s->have_old = s->have_jacobian = s->have_end = 0;
    s->pause = s->longer = 1;
    s->pending = 0;
    s->first = 1;
    s->last_rejected = 0;
    s->err_accepted = 1e-2;
    if (m->crossings == 0) {
        return 0;
    }
    memcpy(s->side, side, (size_t)m->crossings * sizeof(double));
    memcpy(s->slack, slack, (size_t)m->crossings * sizeof(double));
    int code = ac_roots(m, t, x, s->g_old);
    for (int i = 0; code == 0 && i < m->crossings; i++) {
        if (s->side[i] != 0.0 && !isfinite(s->g_old[i])) {
            code = AC_NOT_FINITE;
        }
    }
    return code;
}

enum { TRIALS = 8 };

/* The fixed step is made again, up to `t`. */
static int remade(ac_solver *s, double t)
{
    s->t = s->t1 = t;
    s->h = t - s->t0;
    s->have_dense = 0;
    int code = ac_explicit(s, s->h);
    return code == 0 ? ac_slope(s->model, t, s->x1, s->f1) : code;
}

/* A fixed step ends at the crossing inside it. Where the interpolation found it too early, the step is made a little
 * longer until something has crossed; at last it is the whole step. */
static int shortened(ac_solver *s)
{
    double end = s->t1;
    double before = s->t0;
    double moved = 1e-6 * (end - s->t0);
    double previous = 0.0;
    for (int trial = 0; trial <= TRIALS; trial++) {
        double left = 0.0;
        int code = remade(s, s->t);
        int open = code == 0 && trial < TRIALS && s->t < end ? ac_still_to_cross(s, &left) : 0;
        if (code != 0 || open == 0) {
            return code;
        }
        if (trial > 0 && left < previous) {
            moved = 1.2 * left * (s->t - before) / (previous - left);
        }
        before = s->t;
        previous = left;
        s->t = trial + 1 < TRIALS ? fmin(s->t + moved, end) : end;
    }
    return 0;
}

/* The solver's point is that of the event. */
static int stopped(ac_solver *s)
{
    size_t bytes = (size_t)s->model->states * sizeof(double);
    if (s->method == AC_RODAS5P && s->t < s->t1) {
        ac_interpolate(s, s->t, s->x);
        return 0;
    }
    int code = s->method != AC_RODAS5P && s->t < s->t1 ? shortened(s) : 0;
    memcpy(s->x, s->x1, bytes);
    return code;
}

#define EARLY 1e-3 /* of a step: a crossing before that is found again by a shorter one */

/* A step of variable length and what it crosses. So early in a long step the interpolation says little about
 * parts that settle much faster: what crosses there is looked at with a step that fits. */
static int variable(ac_solver *s, double until)
{
    ac_model *m = s->model;
    size_t roots = (size_t)m->crossings * sizeof(double);
    memcpy(s->slack0, s->slack, roots);
    for (;;) {
        int code = ac_variable_step(s, until);
        if (code != 0) {
            return code;
        }
        s->have_step = 1;
        s->t = s->t1;
        code = ac_search(s);
        double early = s->t - s->t0;
        if (code != AC_EVENT || early >= EARLY * (s->t1 - s->t0) || s->t1 - s->t0 <= 16.0 * s->min_step) {
            return code;
        }
        ac_shorter(s, fmax(8.0 * early, 8.0 * s->min_step));
        memcpy(s->slack, s->slack0, roots);
        code = ac_roots(m, s->t0, s->x0, s->g_old);
        if (code != 0) {
            return code;
        }
    }
}

static int fixed(ac_solver *s, double until)
{
    int code = ac_fixed_step(s, until);
    if (code != 0) {
        return code;
    }
    s->have_step = 1;
    s->t = s->t1;
    return ac_search(s);
}

/* The next step and what it crosses: 0, AC_EVENT or an error. */
static int moved(ac_solver *s, double until)
{
    int code = s->method == AC_RODAS5P ? variable(s, until) : fixed(s, until);
    if (code < 0) {
        return code;
    }
    if (code == AC_EVENT) {
        int problem = stopped(s);
        code = problem != 0 ? problem : code;
    }
    if (s->clock != NULL) { /* once a step: what stands between two steps is part of the second */
        double now = s->clock();
        s->latest = now - s->read;
        s->longest = fmax(s->longest, s->latest);
        s->read = now;
    }
    return code;
}

/* Rows at the grid points up to `t`. */
int ac_written(ac_solver *s, const double *grid, int count, double *rows, int *filled)
{
    int looks = s->have_step && s->method == AC_RODAS5P && s->model->guesses > 0 && !s->have_end;
    if (looks && *filled < count && grid[*filled] <= s->t && grid[*filled] < s->t1) {
        ac_look_from_start(s); /* rows follow the branch that the step began on, as far as it goes */
    }
    while (*filled < count && grid[*filled] <= s->t) {
        double *row = rows + (size_t)*filled * (size_t)s->model->outputs;
        if (s->have_step && !s->have_dense && grid[*filled] < s->t1) {
            ac_hermite(s);
        }
        if (s->have_end && grid[*filled] == s->t1) {
            ac_known(s->model, s->t1, s->x1, s->f1, s->z1);
        }
        if (s->have_step) {
            ac_interpolate(s, grid[*filled], s->stage);
        } else {
            memcpy(s->stage, s->x1, (size_t)s->model->states * sizeof(double));
        }
        int code = ac_row(s->model, grid[*filled], s->stage, row);
        (*filled)++;
        if (code != 0) {
            return code;
        }
    }
    return 0;
}

/* The rows before the point that a step stumbled over, at which the model is left. */
static int finally(ac_solver *s, int code, const double *grid, int count, double *rows, int *filled)
{
    ac_model *m = s->model;
    double t = m->t[0];
    if (code != AC_NOT_FINITE || !s->have_step || !(s->t0 < s->t)) {
        return code;
    }
    size_t bytes = (size_t)m->states * sizeof(double);
    if (m->states > 0) {
        memcpy(s->error, m->x, bytes);
    }
    (void)ac_written(s, grid, count, rows, filled);
    m->settled = 0;
    m->t[0] = t;
    if (m->states > 0) {
        memcpy(m->x, s->error, bytes);
    }
    return code;
}

int ac_sweep(ac_solver *s, const double *grid, int count, double until, ac_long budget, double *rows, int *filled)
{
    int event = s->pending;
    int fit = s->room > 0 && s->room < count ? s->room : count;
    s->pending = 0;
    *filled = 0;
    if (s->clock != NULL) {
        s->read = s->clock();
    }
    for (;;) {
        int code = ac_written(s, grid, fit, rows, filled);
        if (code != 0) {
            return code;
        }
        if (fit < count && *filled == fit && grid[fit] <= s->t) {
            s->pending = event;
            return AC_ROWS;
        }
        if (event) {
            return AC_EVENT;
        }
        if (s->t >= until) {
            break;
        }
        if (count > 0 && *filled == count) {
            return AC_ROWS;
        }
        if (budget-- <= 0) {
            return AC_PAUSE;
        }
        code = moved(s, until);
        if (code != 0 && code != AC_EVENT) {
            return finally(s, code, grid, fit, rows, filled);
        }
        event = code == AC_EVENT;
    }
    memcpy(s->x, s->x1, (size_t)s->model->states * sizeof(double));
    return AC_REACHED;
}

/* The sizes of the structures, for whoever mirrors them. */
void ac_sizes(int *sizes)
{
    sizes[0] = (int)sizeof(ac_function);
    sizes[1] = (int)sizeof(ac_model);
    sizes[2] = (int)sizeof(ac_lu);
    sizes[3] = (int)sizeof(ac_solver);
}
