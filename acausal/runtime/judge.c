/* The sides of roots at an instant: what the relations say there, and how located roots are held after an event. */
#include <math.h>
#include <string.h>

#include "event.h"

#define BAND 1e-9
#define NOISE 1e-14
#define ROUNDING 1e-13
#define FLAT 1e-15
#define HYSTERESIS 1e-10
#define CLEAR 1e-11
#define REST 0.1

void ac_event_literal(const ac_event *e, const double *roots, double *modes)
{
    for (int i = 0; i < e->modes; i++) {
        int positive = e->above[i] ? roots[i] > 0.0 : -roots[i] > 0.0;
        modes[i] = (double)(roots[i] == 0.0 ? e->at_zero[i] : positive);
    }
}

/* Roots and their sizes at the present point. */
void ac_event_look(ac_event *e)
{
    ac_event_solved(e);
    if (e->modes > 0) {
        e->model->roots[0] = NAN;
        (void)ac_call(&e->model->events);
        (void)ac_call(&e->model->scales);
    }
}

/* Roots a moment later along the derivatives; the point is the present one again. */
static void look_ahead(ac_event *e)
{
    ac_model *m = e->model;
    int known = m->free_roots ? m->settled : 0;
    for (int i = 0; i < m->states; i++) {
        e->later[i] = e->x[i] + e->ahead * m->xdot[i];
    }
    ac_event_at(e, e->time + e->ahead, e->later);
    if (!m->free_roots) {
        ac_event_solved(e);
    }
    m->roots[0] = NAN;
    (void)ac_call(&m->events);
    ac_event_at(e, e->time, e->x);
    m->settled = known;
}

/* Whether a located root is too close to zero to say that its relation lost its mode: a root that is solved for has
 * the rounding of all that is solved with it. */
static void close_ones(const ac_event *e, const double *roots, int *close)
{
    for (int i = 0; i < e->modes; i++) {
        close[i] = 0;
    }
    for (int k = 0; k < e->located; k++) {
        int i = e->located_at[k];
        close[i] = fabs(roots[i]) <= fmax(fabs(e->shift[k]), ROUNDING * e->band[k]);
    }
}

/* The values that the relations have now, or a moment later where their root is zero, into `wanted`. A root that was
 * zero in a mode that was tried before at this instant is looked at a moment later, too. */
int ac_event_judge(ac_event *e)
{
    const double *roots = e->model->roots;
    double *seen = e->roots; /* roots and then sizes, before the functions are called again */
    int near = 0;
    ac_event_look(e);
    for (int i = 0; i < e->modes; i++) {
        if (!isfinite(roots[i])) {
            e->which = i;
            return AC_NO_SIDE;
        }
        seen[i] = roots[i];
        seen[e->modes + i] = e->model->sizes[i];
    }
    ac_event_literal(e, seen, e->wanted);
    close_ones(e, seen, e->reached);
    for (int i = 0; i < e->modes; i++) {
        double band = BAND * seen[e->modes + i];
        int crossed = e->crossed[i] != 0;
        int kept = crossed && e->anchored && !e->released[i];
        if (kept) {
            e->wanted[i] = e->m[i];
        }
        int located = crossed && fabs(seen[i] - e->at_roots[i]) <= band;
        e->reached[i] = !kept && (located || fabs(seen[i]) <= band || e->reached[i]);
        near |= e->reached[i] || (e->met[i] && !kept);
        e->met[i] |= e->reached[i];
    }
    if (!near) {
        return 0;
    }
    look_ahead(e);
    for (int i = 0; i < e->modes; i++) {
        if (!e->met[i] || (e->crossed[i] && e->anchored && !e->released[i])) {
            continue;
        }
        if (fabs(roots[i] - seen[i]) > NOISE * seen[e->modes + i]) {
            int positive = e->above[i] ? roots[i] > 0.0 : -roots[i] > 0.0;
            e->wanted[i] = (double)(roots[i] == 0.0 ? e->at_zero[i] : positive);
        } else if (e->reached[i] && (seen[i] != 0.0 || e->undecided)) {
            e->wanted[i] = e->m[i];
        }
    }
    return 0;
}

/* Releases crossings that go against the way that their root goes here: artefacts of a step below the tolerance. So a
 * ball that has just been thrown up is seen to fall, where one step covers its whole flight. */
void ac_event_against(ac_event *e, const int *crossed)
{
    const double *roots = e->model->roots;
    double *seen = e->roots;
    int near = 0;
    ac_event_look(e);
    memcpy(seen, roots, (size_t)e->modes * sizeof(double));
    for (int k = 0; k < e->located; k++) {
        int i = e->located_at[k];
        e->reached[i] = crossed[i] != 0 && fabs(seen[i]) <= BAND * e->band[k];
        near |= e->reached[i];
    }
    if (!near) {
        return;
    }
    look_ahead(e);
    for (int k = 0; k < e->located; k++) {
        int i = e->located_at[k];
        double change = roots[i] - seen[i];
        int back = (change > 0.0 && crossed[i] < 0) || (change < 0.0 && crossed[i] > 0);
        if (e->reached[i] && back && !(fabs(change) <= FLAT * e->band[k])) {
            e->released[i] = 2;
        }
    }
    ac_event_look(e);
}

/* The located roots after two steps along the derivatives, into `reach`: what turns round does not rest. */
static void reached(ac_event *e, double time, const double *x, double ahead)
{
    ac_model *m = e->model;
    for (int i = 1; i <= 2; i++) {
        if (m->guesses == 0 || !m->settled) {
            (void)ac_event_evaluate(e);
        }
        for (int k = 0; k < m->states; k++) {
            e->later[k] = m->x[k] + ahead * m->xdot[k];
        }
        ac_event_at(e, time + i * ahead, e->later);
    }
    if (!m->free_roots) {
        ac_event_solved(e);
    }
    m->roots[0] = NAN;
    (void)ac_call(&m->events);
    for (int k = 0; k < e->located; k++) {
        e->reach[k] = m->roots[e->located_at[k]];
    }
    ac_event_at(e, time, x);
}

void ac_event_hold(ac_event *e, double time, const double *x, double ahead)
{
    const ac_model *m = e->model;
    double *root = e->roots;
    int near = 0;
    memset(e->side, 0, (size_t)e->modes * sizeof(double));
    memset(e->slack, 0, (size_t)e->modes * sizeof(double));
    ac_event_at(e, time, x);
    if (e->located == 0) {
        return;
    }
    ac_event_look(e);
    for (int k = 0; k < e->located; k++) {
        int i = e->located_at[k];
        double size = isfinite(m->sizes[i]) ? m->sizes[i] : 0.0;
        root[k] = m->roots[i];
        e->band[k] = fmax(e->band[k], size);
        e->side[i] = e->above[i] == (e->m[i] != 0.0) ? 1.0 : -1.0;
        double held = fmax(1.01 * fabs(root[k]), 1e-9 * size);
        e->slack[i] = e->side[i] * root[k] > CLEAR * size ? 0.0 : held;
        near |= fabs(root[k]) <= HYSTERESIS * e->band[k];
    }
    if (near) {
        reached(e, time, x, ahead);
    }
    for (int k = 0; k < e->located; k++) {
        int i = e->located_at[k];
        double band = HYSTERESIS * e->band[k];
        if (near && fabs(root[k]) <= band && fabs(e->reach[k] - root[k]) <= REST * band) {
            e->slack[i] = fmax(e->slack[i], band);
        }
        e->shift[k] = e->side[i] * e->slack[i];
        e->slack[i] = fabs(e->shift[k]);
    }
}
