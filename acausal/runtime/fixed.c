/* Steps of one length. Explicit methods keep f at the end of a step as f at the beginning of the next. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "acausal_runtime.h"

/* Dormand and Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6 (1980). */
static const double dopri_a[6][6] = {
    {0, 0, 0, 0, 0, 0},
    {1.0 / 5.0, 0, 0, 0, 0, 0},
    {3.0 / 40.0, 9.0 / 40.0, 0, 0, 0, 0},
    {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0, 0, 0},
    {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0, 0},
    {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0}};
static const double dopri_c[6] = {0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1};
static const double dopri_b[6] = {35.0 / 384.0, 0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0};

static int at(ac_solver *s, double t, double *out)
{
    return ac_slope(s->model, t, s->stage, out);
}

static int dopri(ac_solver *s, double h)
{
    int n = s->model->states;
    memcpy(s->k, s->f0, (size_t)n * sizeof(double));
    for (int stage = 1; stage < 6; stage++) {
        for (int i = 0; i < n; i++) {
            double sum = 0.0;
            for (int j = 0; j < stage; j++) {
                sum += dopri_a[stage][j] * s->k[j * n + i];
            }
            s->stage[i] = s->x0[i] + h * sum;
        }
        int code = at(s, s->t0 + dopri_c[stage] * h, s->k + stage * n);
        if (code != 0) {
            return code;
        }
    }
    for (int i = 0; i < n; i++) {
        double sum = 0.0;
        for (int j = 0; j < 6; j++) {
            sum += dopri_b[j] * s->k[j * n + i];
        }
        s->x1[i] = s->x0[i] + h * sum;
    }
    return 0;
}

/* Heun's third-order method: f at 0, h/3, 2h/3. */
static int third_order(ac_solver *s, double h)
{
    int n = s->model->states;
    double *k2 = s->k + n;
    double *k3 = k2 + n;
    for (int i = 0; i < n; i++) {
        s->stage[i] = s->x0[i] + h / 3.0 * s->f0[i];
    }
    int code = at(s, s->t0 + h / 3.0, k2);
    if (code != 0) {
        return code;
    }
    for (int i = 0; i < n; i++) {
        s->stage[i] = s->x0[i] + 2.0 * h / 3.0 * k2[i];
    }
    code = at(s, s->t0 + 2.0 * h / 3.0, k3);
    for (int i = 0; code == 0 && i < n; i++) {
        s->x1[i] = s->x0[i] + h * (0.25 * s->f0[i] + 0.75 * k3[i]);
    }
    return code;
}

static int heun(ac_solver *s, double h)
{
    int n = s->model->states;
    const double *restrict x0 = s->x0, *restrict f0 = s->f0, *restrict k = s->k;
    double *restrict stage = s->stage, *restrict x1 = s->x1;
    for (int i = 0; i < n; i++) {
        stage[i] = x0[i] + h * f0[i];
    }
    int code = at(s, s->t0 + h, s->k);
    if (code != 0) {
        return code;
    }
    for (int i = 0; i < n; i++) {
        x1[i] = x0[i] + 0.5 * h * (f0[i] + k[i]);
    }
    return 0;
}

/* Adams and Bashforth's second-order method with the last two slopes; Heun's where there is only one. */
static int two_step(ac_solver *s, double h)
{
    if (!s->have_old) {
        return heun(s, h);
    }
    double ratio = 0.5 * h / s->h_old;
    for (int i = 0; i < s->model->states; i++) {
        s->x1[i] = s->x0[i] + h * ((1.0 + ratio) * s->f0[i] - ratio * s->f_old[i]);
    }
    return 0;
}

static int implicit(ac_solver *s, double h, const ac_rosenbrock *table)
{
    ac_model *m = s->model;
    int code = 0;
    if (!s->have_jacobian) {
        code = ac_matrix(m, s->t0, s->x0);
        code = code == 0 ? ac_rate(m, s->t0, s->x0, s->f0, h, s->ratio + m->entries) : code;
        if (code != 0) {
            return code;
        }
        s->have_jacobian = 1;
    }
    code = ac_prepare(s, h, table->gamma);
    return code == 0 ? ac_stages(s, table, h) : code;
}

static int stepped(ac_solver *s, double h)
{
    switch (s->method) {
    case AC_AB2:
        return two_step(s, h);
    case AC_HEUN:
        return heun(s, h);
    case AC_RK3:
        return third_order(s, h);
    case AC_DOPRI5:
        return dopri(s, h);
    case AC_LIEULER:
        return implicit(s, h, &ac_lieuler);
    case AC_ROS2:
        return implicit(s, h, &ac_ros2);
    default:
        for (int i = 0; i < s->model->states; i++) {
            s->x1[i] = s->x0[i] + h * s->f0[i];
        }
        return 0;
    }
}

/* x1 at t0 + h from x0 at t0 and f0 there. Whether all is finite shows at the end, where x1 is: only if it is not,
 * f0 is computed and the step made again, looking at every slope, for the point at which the trouble begins. */
int ac_explicit(ac_solver *s, double h)
{
    ac_model *m = s->model;
    if (m->states == 0) {
        return 0;
    }
    m->unchecked = 1;
    int code = stepped(s, h);
    m->unchecked = 0;
    if (code != 0 || ac_finite(s->x1, m->states)) {
        return code;
    }
    code = ac_slope(m, s->t0, s->x0, s->f0);
    return code == 0 ? stepped(s, h) : code;
}

/* Dense output by a cubic through both ends and slopes, made when it is first asked for. */
void ac_hermite(ac_solver *s)
{
    s->have_dense = 1;
    for (int i = 0; i < s->model->states; i++) {
        double rise = s->x1[i] - s->x0[i];
        s->k1[i] = s->h * s->f0[i] - rise;
        s->k2[i] = rise - s->h * s->f1[i] - s->k1[i];
        s->k3[i] = 0.0;
    }
}

static int finished(ac_solver *s)
{
    s->model->unchecked = 1; /* the next step looks at what comes of it */
    int code = ac_slope(s->model, s->t1, s->x1, s->f1);
    s->model->unchecked = 0;
    if (code != 0) {
        return code;
    }
    s->have_dense = 0;
    s->steps++;
    return s->steps > s->max_steps ? AC_TOO_MANY_STEPS : 0;
}

/* One step from (t1, x1) to the next point of the grid origin + index step, or to `until` if that is nearer. */
int ac_fixed_step(ac_solver *s, double until)
{
    if (s->have_f0 && s->have_step) {
        double *oldest = s->f_old;
        s->f_old = s->f0;
        s->f0 = s->f1;
        s->f1 = oldest;
        s->h_old = s->h;
        s->have_old = 1;
    }
    double *start = s->x1;
    s->x1 = s->x0;
    s->x0 = start;
    s->t0 = s->t1;
    if (!s->have_f0) {
        int code = ac_slope(s->model, s->t0, s->x0, s->f0);
        if (code != 0) {
            return code;
        }
        s->have_f0 = 1;
        s->have_old = 0;
    }
    s->have_jacobian = 0;
    double end = s->origin + (double)s->index * s->step;
    while (end - s->t0 <= 1e-9 * s->step) {
        s->index++;
        end = s->origin + (double)s->index * s->step;
    }
    s->t1 = until - end > 1e-9 * s->step ? end : until;
    s->h = s->t1 - s->t0;
    int code = ac_explicit(s, s->h);
    if (code == AC_MEMORY) { /* as if nothing had happened: it is tried again */
        s->x0 = s->x1;
        s->x1 = start;
        s->t1 = s->t0;
        s->have_f0 = 0;
    }
    return code == 0 ? finished(s) : code;
}
