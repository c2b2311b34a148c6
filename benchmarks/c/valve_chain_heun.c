/* The chain of valves by Heun's method: prints seconds, steps, and the states at the output points. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "valve_chain.h"

int main(int count, char **words)
{
    (void)count;
    double stop = atof(words[1]);
    int points = atoi(words[2]), repeats = atoi(words[3]), each = atoi(words[4]);
    static double rows[100000][N];
    double x[N], y[N], f[N], g[N];
    for (int k = 0; k < repeats; k++) {
        clock_t began = clock();
        long step = 0;
        double h = stop / points / each;
        for (int i = 0; i < N; i++) {
            x[i] = 0.0;
        }
        for (int i = 0; i < points; i++) {
            for (int j = 0; j < each; j++, step++) {
                double t = h * (double)step;
                derivatives(t, x, f);
                for (int p = 0; p < N; p++) {
                    y[p] = x[p] + h * f[p];
                }
                derivatives(t + h, y, g);
                for (int p = 0; p < N; p++) {
                    x[p] += 0.5 * h * (f[p] + g[p]);
                }
            }
            for (int p = 0; p < N; p++) {
                rows[i][p] = x[p];
            }
        }
        printf("%.9f %ld\n", (double)(clock() - began) / CLOCKS_PER_SEC, step);
    }
    for (int i = 0; i < points; i++) {
        for (int j = 0; j < N; j++) {
            printf("%.17g%c", rows[i][j], j + 1 < N ? ' ' : '\n');
        }
    }
    return 0;
}
