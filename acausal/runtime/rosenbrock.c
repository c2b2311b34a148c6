/* Rosenbrock methods in the form without products with the Jacobian (Hairer and Wanner, Solving Ordinary
 * Differential Equations II, 1996, IV.7):
 *
 *     (1 / (h gamma) - J) k_i = f(t + alpha_i h, x + sum a_ij k_j) + sum c_ij / h k_j + d_i h df/dt,
 *     x(t + h) = x + sum m_i k_i,  error = sum e_i k_i.
 */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "acausal_runtime.h"

/* RODAS5P: order 5(4), stiffly accurate, dense output of order 4. Steinebach, Construction of Rosenbrock-Wanner
 * method Rodas5P and numerical benchmarks within the Julia Differential Equations package, BIT 63 (2023). */
static const double rodas5p_a[64] = {
    0, 0, 0, 0, 0, 0, 0, 0,
    3.0, 0, 0, 0, 0, 0, 0, 0,
    2.849394379747939, 0.45842242204463923, 0, 0, 0, 0, 0, 0,
    -6.954028509809101, 2.489845061869568, -10.358996098473584, 0, 0, 0, 0, 0,
    2.8029986275628964, 0.5072464736228206, -0.3988312541770524, -0.04721187230404641, 0, 0, 0, 0,
    -7.502846399306121, 2.561846144803919, -11.627539656261098, -0.18268767659942256, 0.030198172008377946, 0, 0, 0,
    -7.502846399306121, 2.561846144803919, -11.627539656261098, -0.18268767659942256, 0.030198172008377946, 1, 0, 0,
    -7.502846399306121, 2.561846144803919, -11.627539656261098, -0.18268767659942256, 0.030198172008377946, 1, 1, 0};
static const double rodas5p_c[64] = {
    0, 0, 0, 0, 0, 0, 0, 0,
    -14.155112264123755, 0, 0, 0, 0, 0, 0, 0,
    -17.97296035885952, -2.859693295451294, 0, 0, 0, 0, 0, 0,
    147.12150275711716, -1.41221402718213, 71.68940251302358, 0, 0, 0, 0, 0,
    165.43517024871676, -0.4592823456491126, 42.90938336958603, -5.961986721573306, 0, 0, 0, 0,
    24.854864614690072, -3.0009227002832186, 47.4931110020768, 5.5814197821558125, -0.6610691825249471, 0, 0, 0,
    30.91273214028599, -3.1208243349937974, 77.79954646070892, 34.28646028294783, -19.097331116725623,
    -28.087943162872662, 0, 0,
    37.80277123390563, -3.2571969029072276, 112.26918849496327, 66.9347231244047, -40.06618937091002,
    -54.66780262877968, -9.48861652309627, 0};
static const double rodas5p_alpha[8] = {
    0, 0.6358126895828704, 0.4095798393397535, 0.9769306725060716, 0.4288403609558664, 1, 1, 1};
static const double rodas5p_d[8] = {
    0.21193756319429014, -0.42387512638858027, -0.3384627126235924, 1.8046452872882734, 2.325825639765069, 0, 0, 0};
static const double rodas5p_m[8] = {
    -7.502846399306121, 2.561846144803919, -11.627539656261098, -0.18268767659942256, 0.030198172008377946, 1, 1, 1};
static const double rodas5p_e[8] = {0, 0, 0, 0, 0, 0, 0, 1};
static const double rodas5p_h[24] = {
    25.948786856663858, -2.5579724845846235, 10.433815404888879, -2.3679251022685204, 0.524948541321073,
    1.1241088310450404, 0.4272876194431874, -0.17202221070155493,
    -9.91568850695171, -0.9689944594115154, 3.0438037242978453, -24.495224566215796, 20.176138334709044,
    15.98066361424651, -6.789040303419874, -6.710236069923372,
    11.419903575922262, 2.8879645146136994, 72.92137995996029, 80.12511834622643, -52.072871366152654,
    -59.78993625266729, -0.15582684282751913, 4.883087185713722};
const ac_rosenbrock ac_rodas5p = {
    8, 5, 0.21193756319429014, rodas5p_a, rodas5p_c, rodas5p_alpha, rodas5p_d, rodas5p_m, rodas5p_e, rodas5p_h};

/* RODAS3: order 3(2), L-stable, three evaluations, for limited.c. Sandu, Verwer, Blom, Spee, Carmichael and Potra,
 * Benchmarking stiff ODE solvers for atmospheric chemistry problems II: Rosenbrock solvers, Atmos. Environ. 31 (1997). */
static const double rodas3_a[16] = {0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 2, 0, 1, 0};
static const double rodas3_c[16] = {0, 0, 0, 0, 4, 0, 0, 0, 1, -1, 0, 0, 1, -1, -8.0 / 3.0, 0};
static const double rodas3_alpha[4] = {0, 0, 1, 1};
static const double rodas3_d[4] = {0.5, 1.5, 0, 0};
static const double rodas3_m[4] = {2, 0, 1, 1};
static const double rodas3_e[4] = {0, 0, 0, 1};
const ac_rosenbrock ac_rodas3 = {4, 3, 0.5, rodas3_a, rodas3_c, rodas3_alpha, rodas3_d, rodas3_m, rodas3_e, NULL};

/* Order 2, L-stable, one evaluation; it satisfies the conditions for order 2 of IV.7. With T = 1 / (1 - h J) its step is
 * linearly implicit Euler's k = h T f and what that lacks, damped twice: k - h/2 J T^2 k. A contact that closes within
 * a step is linearised where it is evaluated, and given back no more energy than it took: for that y |R(i y)| must
 * not exceed 1 by much for the stability function R(z) = (1 - 2 z + z^2 / 2) / (1 - z)^3, which for y -> oo is 1/2. */
static const double ros2_a[9] = {0};
static const double ros2_c[9] = {0, 0, 0, -0.5, 0, 0, -0.5, 1, 0};
static const double ros2_alpha[3] = {0};
static const double ros2_d[3] = {1, 0.5, 1};
static const double ros2_m[3] = {0, 0, 1};
static const double ros2_e[3] = {-1, 0, 1};
const ac_rosenbrock ac_ros2 = {3, 2, 1.0, ros2_a, ros2_c, ros2_alpha, ros2_d, ros2_m, ros2_e, NULL};

/* Linearly implicit Euler: order 1, L-stable. */
static const double euler_zero[1] = {0};
static const double euler_one[1] = {1};
const ac_rosenbrock ac_lieuler = {1, 1, 1.0, euler_zero, euler_zero, euler_zero, euler_one, euler_one, euler_one, NULL};

/* W = 1 / (h gamma) - J in nominal units, and its factors. */
int ac_prepare(ac_solver *s, double h, double gamma)
{
    ac_lu *lu = &s->lu;
    const ac_model *m = s->model;
    int entries = lu->ap[lu->n];
    double diagonal = 1.0 / (h * gamma);
    for (int p = 0; p < entries; p++) {
        lu->ax[p] = 0.0;
    }
    for (int p = 0; p < m->entries; p++) {
        lu->ax[s->jmap[p]] = -m->jacobian[p] * s->ratio[p];
    }
    for (int i = 0; i < lu->n; i++) {
        lu->ax[s->diagonal[i]] += diagonal;
    }
    return ac_lu_factor(lu);
}

static void add(double *sum, double factor, const double *v, int n)
{
    if (factor == 0.0) {
        return;
    }
    for (int i = 0; i < n; i++) {
        sum[i] += factor * v[i];
    }
}

/* Whether stage i evaluates where the step begins. */
static int at_start(const ac_rosenbrock *table, int i)
{
    const double *a = table->a + i * table->stages;
    if (table->alpha[i] != 0.0) {
        return 0;
    }
    for (int j = 0; j < i; j++) {
        if (a[j] != 0.0) {
            return 0;
        }
    }
    return 1;
}

/* `f(t + alpha_i h, x0 + sum a_ij k_j)` into `out`. */
static int evaluated(ac_solver *s, const ac_rosenbrock *table, double h, int i, double *out)
{
    int n = s->model->states;
    const double *a = table->a + i * table->stages;
    if (at_start(table, i)) {
        memcpy(out, s->f0, (size_t)n * sizeof(double));
        return 0;
    }
    memcpy(s->stage, s->x0, (size_t)n * sizeof(double));
    for (int j = 0; j < i; j++) {
        add(s->stage, a[j], s->k + j * n, n);
    }
    double t = s->t0 + table->alpha[i] * h;
    return ac_slope(s->model, t, s->stage, out);
}

/* All stages of a step of length h from (t0, x0), with f0 = f(t0, x0) and the factors made; x1, error, k1..k3. */
int ac_stages(ac_solver *s, const ac_rosenbrock *table, double h)
{
    int n = s->model->states;
    int width = table->stages;
    for (int i = 0; i < width; i++) {
        double *k = s->k + i * n;
        int code = evaluated(s, table, h, i, k);
        if (code != 0) {
            return code;
        }
        add(k, h * table->d[i], s->ratio + s->model->entries, n);
        for (int j = 0; j < i; j++) {
            add(k, table->c[i * width + j] / h, s->k + j * n, n);
        }
        for (int p = 0; p < n; p++) {
            k[p] /= s->nominal[p];
        }
        ac_lu_solve(&s->lu, k, k);
        for (int p = 0; p < n; p++) {
            k[p] *= s->nominal[p];
        }
    }
    memcpy(s->x1, s->x0, (size_t)n * sizeof(double));
    memset(s->error, 0, (size_t)n * sizeof(double));
    for (int i = 0; i < width; i++) {
        add(s->x1, table->m[i], s->k + i * n, n);
        add(s->error, table->e[i], s->k + i * n, n);
    }
    if (table->h != NULL) {
        double *const dense[3] = {s->k1, s->k2, s->k3};
        for (int row = 0; row < 3; row++) {
            memset(dense[row], 0, (size_t)n * sizeof(double));
            for (int i = 0; i < width; i++) {
                add(dense[row], table->h[row * width + i], s->k + i * n, n);
            }
        }
    }
    return 0;
}
