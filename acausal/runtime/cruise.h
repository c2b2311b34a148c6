/* From event to event without coming back: rows on both sides, the event itself, and the integrator anew. */
#ifndef ACAUSAL_CRUISE_H
#define ACAUSAL_CRUISE_H

#include "event.h"

enum { AC_RECENT = 100, AC_SHRINKING = 24 };

typedef struct {
    ac_solver *solver;
    ac_event *event;
    double held;               /* how far to look forward for what rests */
    double next;               /* the next event at a known instant */
    double last_row;           /* when the last row was written */
    double shortest, resolved; /* AC_RECENT stops within this time are an accumulation; so are AC_SHRINKING whose
                                * distances shrink below that */
    double *times, *rows;      /* what is written: room for `room` rows */
    int room, filled;
    double *x, *before_x, *before_m, *before_d, *before_count, *before_guess;
    double *recent;            /* the last stops, in turn, and what was involved: modes and unknowns */
    unsigned char *involved;
    ac_long *tally;            /* events that each mode and unknown took part in */
    ac_long stops, events;     /* stops noted; those at which something happened */
} ac_cruise;

/* Numbers for `x` and what stands before an event, handed out by `ac_cruise_init`. */
int ac_cruise_doubles(const ac_event *e);
void ac_cruise_init(ac_cruise *c, double *doubles);
/* Goes on to `stop`, with outputs at the `count` times of `grid`, of which `done` are passed. What is not simple is left
 * to the caller: after AC_EVENT, and after AC_REACHED with `next` reached, the event is still to come. AC_CROWDED: events
 * accumulate. Else as `ac_sweep`. */
int ac_cruise_on(ac_cruise *c, const double *grid, int count, double stop, ac_long budget, int *done);
/* The sizes of ac_event and ac_cruise, AC_RECENT, AC_SHRINKING. */
void ac_cruise_sizes(int *sizes);

#endif
