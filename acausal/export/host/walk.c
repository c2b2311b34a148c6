/* Programs walked piece by piece, with robust solvers: at the start, and where the integrator's functions fail. What
 * cannot be computed is named. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "acausal_host.h"

#define CONSISTENT 1e-6

int ac_say(ac_run *r, int code, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    if (vsnprintf(r->message, sizeof r->message, format, values) < 0) {
        r->message[0] = '\0';
    }
    va_end(values);
    return code;
}

void ac_keep(ac_run *r)
{
    if (r->first[0] == '\0') {
        memcpy(r->first, r->message, sizeof r->first);
    }
}

/* Calls a function of up to two arrays. */
int ac_from(ac_run *r, ac_entry entry, const double *a, const double *b, double *result, double *second)
{
    if (entry == NULL) {
        return 0;
    }
    r->arg[0] = a;
    r->arg[1] = b;
    r->res[0] = result;
    r->res[1] = second;
    return entry(r->arg, r->res, r->iw, r->w, 0);
}

/* r and J at `z`, J by rows; the known values are in `r->known`. 0 where something is not finite. */
int ac_residual(ac_run *r, const ac_segment *s, const double *z, double *residual, double *matrix)
{
    int n = s->tearing;
    int entries = s->columns[n];
    double *packed = r->block + 9 * n * n + 16 * n;
    residual[0] = NAN;
    int code = ac_from(r, s->residual, z, r->known, residual, packed);
    memset(matrix, 0, (size_t)n * (size_t)n * sizeof(double));
    for (int k = 0; k < n; k++) {
        for (int p = s->columns[k]; p < s->columns[k + 1]; p++) {
            matrix[s->rows[p] * n + k] = packed[p];
        }
    }
    return code == 0 && ac_finite(residual, n) && ac_finite(packed, entries);
}

/* A system that is singular has the solution of minimum norm in units of nominal values, if it has one. */
static int singular(ac_run *r, const ac_segment *s, double *z, const double *nominal, double *right, double *scaled)
{
    int n = s->tearing;
    double *matrix = r->block;
    double *residual = matrix + n * n;
    double *terms = scaled + n * n;
    ac_minimum_norm(scaled, n, right, z, terms + n);
    for (int i = 0; i < n; i++) {
        z[i] *= nominal[i];
    }
    memset(right, 0, (size_t)n * sizeof(double));
    if (ac_from(r, s->terms, right, r->known, terms, NULL) != 0) {
        return 0;
    }
    for (int i = 0; i < n; i++) {
        double off = residual[i];
        for (int k = 0; k < n; k++) {
            off += matrix[i * n + k] * z[k];
            terms[i] += fabs(matrix[i * n + k] * z[k]);
        }
        if (!(fabs(off) <= CONSISTENT * terms[i])) {
            return 0;
        }
    }
    return 1;
}

static int linear(ac_run *r, const ac_segment *s, double *z, const double *nominal)
{
    int n = s->tearing;
    double *matrix = r->block;
    double *residual = matrix + n * n;
    double *right = residual + n;
    double *scaled = right + n;
    memset(z, 0, (size_t)n * sizeof(double));
    if (!ac_residual(r, s, z, residual, matrix)) {
        return 0;
    }
    for (int i = 0; i < n; i++) {
        double size = 0.0;
        for (int k = 0; k < n; k++) {
            size += fabs(matrix[i * n + k]) * nominal[k];
        }
        size = size > 0.0 ? size : 1.0;
        for (int k = 0; k < n; k++) {
            scaled[i * n + k] = matrix[i * n + k] * nominal[k] / size;
        }
        right[i] = -residual[i] / size;
    }
    if (ac_dense_solve(scaled, n, right, z, scaled + n * n, r->pivots)) {
        for (int i = 0; i < n; i++) {
            z[i] *= nominal[i];
        }
        return 1;
    }
    return singular(r, s, z, nominal, right, scaled);
}

static int solved(ac_run *r, const ac_segment *s, const double *guess, int initial)
{
    int n = s->tearing;
    double *z = r->found;
    double *nominal = r->block + 10 * n * n + 16 * n;
    for (int i = 0; i < n; i++) {
        nominal[i] = s->nominal[i] >= 0 ? r->nominal[s->nominal[i]] : 1.0;
        z[i] = s->guess[i] >= 0 ? guess[s->guess[i]] : 0.0;
    }
    return s->kind == AC_LINEAR ? linear(r, s, z, nominal) : ac_newton(r, s, z, nominal, initial);
}

static int unsolved(ac_run *r, const ac_program *program, const ac_segment *s, int initial)
{
    const char *kind = s->kind == AC_LINEAR ? "linear equations has no" : "nonlinear equations: found no";
    const char *name = program->name[s->write[0]];
    const char *more = s->writes > 1 ? program->name[s->write[s->writes - 1]] : name;
    return ac_say(r, AC_FAILED, "a block of %d %s solution at time %.12g s in the %s system: unknowns %s to %s (%s)",
                  s->writes, kind, r->model.t[0], initial ? "initial" : "running", name, more,
                  program->place[s->write[0]]);
}

/* The first jump of a run from one branch of solutions to another is passed on. */
static void jumped(ac_run *r, const ac_program *program, const ac_segment *s, const double *guess)
{
    char text[AC_MESSAGE];
    const ac_notice notice = {text, program->place[s->write[0]], 1};
    double before = s->guess[0] >= 0 ? guess[s->guess[0]] : 0.0;
    if (r->jumped || r->settings.warn == NULL) {
        return;
    }
    r->jumped = 1;
    r->warnings++;
    (void)snprintf(text, sizeof text, "the solution of a nonlinear block ended, and another one was taken: %s from %.6g to %.6g",
                   program->name[s->write[0]], before, r->found[0]);
    r->settings.warn(r->settings.owner, r->model.t[0], &notice);
}

static int not_finite(ac_run *r, const ac_program *program, int slot)
{
    return ac_say(r, AC_FAILED, "%s is %s at time %.12g s (%s)", program->name[slot],
                  isnan(r->values[slot]) ? "not a number" : "infinite", r->model.t[0], program->place[slot]);
}

/* All values, of which the inputs stand in `r->values` already; `guess` is where blocks begin. */
int ac_walk(ac_run *r, const ac_program *program, const double *guess, int initial)
{
    for (int i = 0; i < program->count; i++) {
        const ac_segment *s = &program->segment[i];
        int code = 0;
        for (int k = 0; k < s->reads; k++) {
            r->known[k] = r->values[s->read[k]];
        }
        int found = s->kind == AC_EXPLICIT ? 1 : solved(r, s, guess, initial);
        if (found == 0) {
            return unsolved(r, program, s, initial);
        }
        if (found == 2) {
            jumped(r, program, s, guess);
        }
        if (s->kind == AC_EXPLICIT) {
            code = ac_from(r, s->run, r->known, NULL, r->found, NULL);
        } else {
            code = ac_from(r, s->run, r->found, r->known, r->found + s->tearing, NULL);
        }
        for (int k = 0; k < s->writes; k++) {
            r->values[s->write[k]] = code == 0 ? r->found[k] : NAN;
        }
        for (int k = 0; k < s->writes; k++) {
            if (!isfinite(r->values[s->write[k]])) {
                return not_finite(r, program, s->write[k]);
            }
        }
    }
    return 0;
}
