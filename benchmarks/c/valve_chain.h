/* A chain of relief valves written by hand: states p, s, v of valve 0, then of valve 1, and so on.
 *
 *     V / K dp_i/dt = q_(i-1) + A v_(i-1) - q_i - A v_i,  q_i = C h(s_i) dp / (dp^2 + D^2)^(1/4), dp = p_i - p_(i+1)
 *     m dv_i/dt = A (p_i - p_(i+1)) - c s_i - d v_i - F
 *
 * with the opening h(s) = (s + sqrt(s^2 + e^2)) / 2, a supply at 20 bar that swings by 5 bar, and a tank. */
#include <math.h>

#ifndef VALVES
#define VALVES 46
#endif
#define N (3 * VALVES)

static const double K = 1.2e9, V = 2e-5, A = 1e-4, M = 0.02, C_S = 8e3, D_S = 12.0, F = 2.0, C = 2.5e-4, D = 1e4,
                    E_S = 2e-5, P_MEAN = 20e5, P_SWING = 5e5, OMEGA = 12.566370614359172, H_IN = 1e-3;

static double flow(double h, double dp, double *d_dp)
{
    double u = dp * dp + D * D;
    double r = 1.0 / sqrt(sqrt(u));
    *d_dp = C * h * r * (1.0 - 0.5 * dp * dp / u);
    return C * h * r * dp;
}

static void derivatives(double t, const double *x, double *f)
{
    double dummy;
    double q = flow(H_IN, P_MEAN + P_SWING * sin(OMEGA * t) - x[0], &dummy);
    for (int i = 0; i < VALVES; i++) {
        double p = x[3 * i], s = x[3 * i + 1], v = x[3 * i + 2];
        double next = i + 1 < VALVES ? x[3 * i + 3] : 0.0;
        double out = flow(0.5 * (s + sqrt(s * s + E_S * E_S)), p - next, &dummy);
        f[3 * i] = K / V * (q - out - A * v);
        f[3 * i + 1] = v;
        f[3 * i + 2] = (A * (p - next) - C_S * s - D_S * v - F) / M;
        q = out + A * v;
    }
}
