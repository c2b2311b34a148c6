/* Steps that nothing but their limit keeps short.
 *
 * Where the longest step allowed is far below what the accuracy asks for, order 5 is wasted: RODAS3, of order 3, makes
 * such a step with three evaluations instead of eight and half the solutions of linear systems. It is tried with what
 * is known at the step's start; where its error is more than a small part of the tolerance, RODAS5P makes the step, and
 * the next so many. The end's derivatives serve the dense output (Hermite's) and the next step. */
#include <math.h>
#include <string.h>

#include "acausal_runtime.h"

#define ENOUGH 0.1 /* of the tolerance */

enum { LONGEST_PAUSE = 64 };

static int is_limited(const ac_solver *s, double h)
{
    int asked = s->max_step > 0.0 && s->h_next >= s->max_step;
    return asked && h >= 0.5 * s->max_step && s->model->states > 0;
}

/* A step of length `h`, which is to end at `end`, if it is such a one: 0, AC_REFUSED, or AC_MEMORY. */
int ac_limited_step(ac_solver *s, double h, double end)
{
    ac_model *m = s->model;
    if (!is_limited(s, h)) {
        return AC_REFUSED;
    }
    if (s->pause > 0) {
        s->pause--;
        return AC_REFUSED;
    }
    int code = ac_prepare(s, h, ac_rodas3.gamma);
    code = code == 0 ? ac_stages(s, &ac_rodas3, h) : code;
    if (code == AC_MEMORY) {
        return code;
    }
    double e = code == 0 ? ac_measured(s) : INFINITY;
    if (!(e <= ENOUGH) || ac_slope(m, end, s->x1, s->f1) != 0) {
        s->pause = s->longer;
        s->longer = s->longer < LONGEST_PAUSE ? 2 * s->longer : LONGEST_PAUSE;
        return AC_REFUSED;
    }
    ac_blame(s, e, 0);
    if (m->guesses > 0) {
        memcpy(s->z1, m->z, (size_t)m->guesses * sizeof(double));
    }
    s->h = h;
    s->t1 = end;
    s->have_end = 1;
    s->have_dense = 0;
    s->longer = 1;
    s->h_accepted = h;
    s->err_accepted = 1e-2;
    s->last_rejected = 0;
    s->steps++;
    return s->steps + s->rejected > s->max_steps ? AC_TOO_MANY_STEPS : 0;
}
