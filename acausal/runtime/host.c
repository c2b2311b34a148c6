/* What only a host with an operating system has: a clock. */
#define _POSIX_C_SOURCE 199309L
#include <time.h>

#include "acausal_runtime.h"

double ac_clock(void)
{
    struct timespec now;
    if (clock_gettime(CLOCK_MONOTONIC, &now) != 0) {
        return 0.0;
    }
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
