/* Events: what changes at an instant, and when the next one is known to be.
 *
 * An `ac_event` stands beside an `ac_model` and shares its modes and frozen values. All arrays belong to the caller. */
#ifndef ACAUSAL_EVENT_H
#define ACAUSAL_EVENT_H

#include "acausal_runtime.h"

/* What `ac_event_settle` returns beside 0. */
enum {
    AC_CIRCLE = 30,  /* modes go round in circles: see `disputed`, `seen_m`, `seen_d` */
    AC_ENDLESS = 31, /* values before the event (`which`, or -1: states are reset) change in every iteration */
    AC_NO_SIDE = 32, /* condition `which` is not a number */
    AC_NO_VALUE = 33, /* discrete variable `which` is not a number */
    AC_NO_STATE = 35, /* reset `which` is not finite */
    AC_UNSOLVED = 34  /* the blocks have no solution, or what `solve` returned */
};

typedef struct {
    ac_model *model;
    int modes, frozen, unknowns, memory, samples, resets, checks, stops, located, instants;
    int brief;                 /* gives up where something does not settle at once */
    const int *located_at;     /* modes whose roots are looked for */
    const int *above, *at_zero; /* of every mode: whether it holds for positive roots, and for zero */
    const int *judged;         /* of every remembered value: whether a change of it goes on with the event */
    const int *whole;          /* of every mode: whether it watches an `integer(...)` */
    const int *reset_state;    /* which state each `reinit` sets */
    double *m, *d;             /* modes; frozen values: unknowns, remembered values, samples, phases */
    ac_function update, recall, actions, ahead_of; /* new unknowns, remembered values, actions, known instants */
    double *new_d, *new_memory, *action, *instant;  /* their results */
    int (*solve)(void *owner); /* solves the blocks at the point by all means, or null */
    void *owner;
    double *kept_z;            /* the blocks' last solution at an event, or null */
    double *shift, *band;      /* of located roots: see ac_event_hold; largest sizes so far */
    double *sample_start, *sample_interval, *sample_count;
    double ahead;              /* how far to look forward where a root is zero */

    /* The present event. */
    double time;
    double *x, *at_roots;      /* states, and roots where the solver stopped */
    double *fired;             /* checks and stops that were met */
    int *crossed, *met, *released; /* modes: located here, zero in a mode that was tried, not held by its crossing */
    int *disputed, *reached;
    int anchored, undecided, which;
    double *later, *roots, *wanted, *start_m, *start_d, *old_m, *old_d, *seen_m, *seen_d, *past, *reach, *side, *slack;
} ac_event;

enum { AC_BRIEF = 8 }; /* passes that are compared with each other where `brief` is set */

/* Memory: with the counts set, numbers and integers of `ac_event_init`, which hands them out. */
#define AC_EVENT_DOUBLES(states, modes, frozen, located, actions, fired, instants) \
    (2 * (states) + (8 + AC_BRIEF) * (modes) + (5 + AC_BRIEF) * (frozen) + (located) + (actions) + (fired) + (instants))
int ac_event_doubles(const ac_event *e);
int ac_event_ints(const ac_event *e);
void ac_event_init(ac_event *e, double *doubles, int *ints);

/* Iterates to a fixed point at (time, x), and changes `x`. `crossed` marks the roots that brought the solver here. */
int ac_event_settle(ac_event *e, double time, double *x, const int *crossed);
/* What holds now is what held before the event. */
void ac_event_recall(ac_event *e);
/* Sets `shift`, `side` and `slack` at (time, x), so that a crossing that was just handled is not found again, and rest
 * makes no event. */
void ac_event_hold(ac_event *e, double time, const double *x, double ahead);
/* The first instant after `time`; infinite if there is none. */
double ac_event_upcoming(ac_event *e, double time);
/* 1 for every sample whose instant this is, and 0; those instants are then past. Whether there is one. */
int ac_event_due(ac_event *e, double time, double *due);
int ac_event_is_reached(double time, double instant);
int ac_event_same(const double *a, const double *b, int n);
/* What the relations say by their roots alone. */
void ac_event_literal(const ac_event *e, const double *roots, double *modes);
/* Writes modes or frozen values; where they change the blocks must be solved again. */
void ac_event_put(ac_event *e, double *to, const double *from, int n);
void ac_event_at(ac_event *e, double time, const double *x);
int ac_event_judge(ac_event *e);
void ac_event_against(ac_event *e, const int *crossed);
void ac_event_look(ac_event *e);
int ac_event_evaluate(ac_event *e);
void ac_event_solved(ac_event *e);

#endif
