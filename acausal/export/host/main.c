/* Runs the model from the command line: all rows of a table of parameters, one result for each. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "MODEL.h"
#include "csv.h"

enum { LINE = 1 << 20, FIELDS = MODEL_TUNABLES + 1, GIVEN = MODEL_INPUTS + 1 };

static const char *const usage =
    "usage: MODEL [-p TABLE.csv] [-r RESULTS.csv] [-o TRAJECTORIES.csv] [-u INPUT=VALUE]... [-t INPUTS.csv]\n"
    "             [--start T] [--stop T] [--step H] [--interval H] [--solver NAME] [--events locate|step] [--list]\n"
    "-p  one variant in each row; the header names tunable parameters\n"
    "-r  final values of every variant (default: standard output)\n"
    "-o  the course of every variant over time\n"
    "-u  a constant input; -t  inputs over time, the first column is the time\n"
    "--list  what can be tuned, given and had\n";

static const char *const methods[] = {"", "euler", "ab2", "heun", "rk3", "dopri5", "lieuler", "rosenbrock"};

typedef struct {
    const char *table, *results, *rows, *inputs;
    ac_settings settings;
    ac_series given[GIVEN];
} request;

typedef struct {
    FILE *rows;
    long variant;
    double last[MODEL_OUTPUTS + 1];
    double time;
} course;

static MODEL_instance instance;
static char line[LINE];
static double factor_sum, longest;

static int complain(const char *what, const char *name)
{
    (void)fprintf(stderr, "error: %s%s%s\n", what, name[0] != '\0' ? " " : "", name);
    return 2;
}

static int row(void *owner, double time, const double *values)
{
    course *c = owner;
    c->time = time;
    memcpy(c->last, values, MODEL_OUTPUTS * sizeof(double));
    if (c->rows == NULL) {
        return 0;
    }
    int problem = fprintf(c->rows, "%ld,%.17g", c->variant, time) < 0;
    for (int i = 0; i < MODEL_OUTPUTS; i++) {
        problem |= fprintf(c->rows, ",%.17g", values[i]) < 0;
    }
    return problem | (fputc('\n', c->rows) == EOF);
}

static void warn(void *owner, double time, const ac_notice *notice)
{
    const course *c = owner;
    (void)fprintf(stderr, "variant %ld: warning: %s (first at time %.12g s; %s)\n", c->variant, notice->text, time,
                  notice->place);
}

static void header(FILE *file, const char *first)
{
    (void)fputs(first, file);
    for (int i = 0; i < MODEL_OUTPUTS; i++) {
        (void)fputc(',', file);
        csv_text(file, MODEL_plan.variable[i].name);
    }
    (void)fputc('\n', file);
}

/* One variant; whether it came to its end. */
static int ran(const request *q, course *c, FILE *results, const double *values, const int *which, int count, int bad)
{
    ac_run *r = &instance.run;
    int code = MODEL_create(&instance);
    for (int i = 0; i < MODEL_INPUTS; i++) {
        instance.inputs[i] = q->given[i];
    }
    for (int i = 0; code == 0 && i < count; i++) {
        code = ac_set(r, which[i], values[i]);
    }
    if (code == 0 && bad) {
        code = ac_say(r, AC_FAILED, "the row of the table is not complete, or holds what is no number");
    }
    clock_t began = clock();
    code = code == 0 ? ac_start(r, &q->settings) : code;
    code = code == 0 ? ac_go(r) : code;
    double seconds = (double)(clock() - began) / (double)CLOCKS_PER_SEC;
    double span = q->settings.stop_time - q->settings.start_time;
    factor_sum += span > 0.0 ? seconds / span : 0.0;
    longest = fmax(longest, r->longest);
    (void)fprintf(results, "%ld,", c->variant);
    if (code < 0) {
        (void)fputs("\"error: ", results);
        for (const char *p = r->message; *p != '\0'; p++) {
            (void)fputs(*p == '"' ? "\"\"" : *p == '\n' ? " " : (const char[2]){*p, '\0'}, results);
        }
        (void)fprintf(results, "\",%.17g", r->time);
        (void)fprintf(stderr, "variant %ld: %s\n", c->variant, r->message);
    } else {
        (void)fprintf(results, "%s,%.17g", code == AC_ENDED ? "ended" : "ok", c->time);
        if (code == AC_ENDED) {
            (void)fprintf(stderr, "variant %ld: ended: %s\n", c->variant, r->message);
        }
    }
    for (int i = 0; i < MODEL_OUTPUTS; i++) {
        if (code < 0) {
            (void)fputc(',', results);
        } else {
            (void)fprintf(results, ",%.17g", c->last[i]);
        }
    }
    (void)fputc('\n', results);
    return code >= 0;
}

static int number(const ac_tunable *t, const char *text, double *value)
{
    const char *dot = strrchr(text, '.');
    for (int i = 0; i < t->literals; i++) {
        if (strcmp(text, t->literal[i]) == 0 || (dot != NULL && strcmp(dot + 1, t->literal[i]) == 0)) {
            *value = i + 1;
            return 1;
        }
    }
    if (t->type == AC_BOOLEAN && (strcmp(text, "true") == 0 || strcmp(text, "false") == 0)) {
        *value = text[0] == 't';
        return 1;
    }
    return csv_number(text, value);
}

/* Which tunables the columns are; -1 where one is unknown. */
static int columns(char *rest, int *which)
{
    int count = 0;
    for (char *name = csv_field(&rest); name != NULL; name = csv_field(&rest)) {
        int found = -1;
        for (int i = 0; i < MODEL_TUNABLES; i++) {
            found = strcmp(MODEL_plan.tunable[i].name, name) == 0 ? i : found;
        }
        for (int i = 0; i < count; i++) {
            found = which[i] == found ? -1 : found;
        }
        if (found < 0) {
            (void)complain("this is no tunable parameter, or it is named twice:", name);
            return -1;
        }
        which[count++] = found;
    }
    return count;
}

/* All rows; how many failed, or -1. */
static long all(const request *q, course *c, FILE *results)
{
    static double values[FIELDS];
    static int which[FIELDS];
    long failed = 0;
    if (q->table == NULL) {
        c->variant = 1;
        return !ran(q, c, results, values, which, 0, 0);
    }
    FILE *table = fopen(q->table, "r");
    int more = table != NULL ? csv_line(table, line, LINE) : 0;
    int count = more == 1 ? columns(line, which) : complain("cannot read the table", q->table) - 3;
    while (count >= 0 && (more = csv_line(table, line, LINE)) == 1) {
        char *rest = line;
        int bad = 0;
        int i = 0;
        for (char *text = csv_field(&rest); text != NULL; text = csv_field(&rest), i++) {
            bad |= i >= count || !number(&MODEL_plan.tunable[which[i]], text, &values[i]);
        }
        c->variant++;
        failed += !ran(q, c, results, values, which, bad || i < count ? 0 : count, bad || i < count);
    }
    if (more < 0) {
        (void)complain("a line is too long in", q->table);
    }
    if (table != NULL) {
        (void)fclose(table);
    }
    return count < 0 || more < 0 ? -1 : failed;
}

static int input_of(const char *name, size_t length)
{
    for (int i = 0; i < MODEL_INPUTS; i++) {
        const char *known = MODEL_plan.input[i].name;
        if (strncmp(known, name, length) == 0 && known[length] == '\0') {
            return i;
        }
    }
    return -1;
}

static int constant(request *q, const char *text)
{
    const char *equals = strrchr(text, '=');
    int i = equals != NULL ? input_of(text, (size_t)(equals - text)) : -1;
    if (i < 0 || !csv_number(equals + 1, &q->given[i].constant) ||
        !isfinite(q->given[i].constant)) {
        return complain("this is no INPUT=VALUE of the model:", text);
    }
    q->given[i].given = 1;
    return 0;
}

/* The samples of one input: straight lines, whose kinks the steps end at. */
static void series(ac_series *s, double *kinks, double *time, double *value, int count)
{
    s->given = 1;
    s->kinks = 0;
    s->count = count;
    s->time = time;
    s->value = value;
    s->kink = kinks;
    for (int i = 1; i + 1 < count; i++) {
        double before = (value[i] - value[i - 1]) / (time[i] - time[i - 1]);
        double after = (value[i + 1] - value[i]) / (time[i + 1] - time[i]);
        if (fabs(after - before) > 1e-9 * fmax(fabs(before), fabs(after))) {
            kinks[s->kinks++] = time[i];
        }
    }
}

static int samples(request *q, FILE *file, int which[], int width, int most)
{
    double *memory = malloc((size_t)(2 * width + 1) * (size_t)most * sizeof(double));
    int count = 0;
    int fine = memory != NULL && most >= 2;
    while (fine && count < most && csv_line(file, line, LINE) == 1) {
        char *rest = line;
        for (int k = 0; k <= width; k++) {
            char *text = csv_field(&rest);
            double *to = memory + (size_t)k * (size_t)most + count;
            fine = fine && text != NULL && csv_number(text, to) && isfinite(*to);
        }
        fine = fine && rest == NULL;
        fine = fine && (count == 0 || memory[count] > memory[count - 1]);
        count++;
    }
    double slack = 1e-9 * fmax(q->settings.stop_time - q->settings.start_time, fabs(q->settings.stop_time));
    if (!fine || count < 2 || memory[0] > q->settings.start_time + slack ||
        memory[count - 1] < q->settings.stop_time - slack) {
        free(memory);
        return complain("times must increase and cover the run, and all fields be numbers, in", q->inputs);
    }
    for (int k = 1; k <= width; k++) {
        series(&q->given[which[k]], memory + (size_t)(width + k) * (size_t)most, memory, memory + (size_t)k * (size_t)most,
               count);
    }
    return 0; /* the samples live as long as the program does */
}

static int inputs(request *q)
{
    static int which[GIVEN + 1];
    FILE *file = q->inputs != NULL ? fopen(q->inputs, "r") : NULL;
    int width = -1;
    int most = -1;
    if (q->inputs == NULL) {
        return 0;
    }
    if (file == NULL) {
        return complain("cannot read", q->inputs);
    }
    while (csv_line(file, line, LINE) == 1) {
        most++;
    }
    rewind(file);
    (void)csv_line(file, line, LINE);
    char *rest = line;
    for (char *name = csv_field(&rest); name != NULL; name = csv_field(&rest)) {
        width++;
        which[width] = width > 0 && width <= MODEL_INPUTS ? input_of(name, strlen(name)) : -1;
        int fine = width == 0 ? strcmp(name, "time") == 0 : width <= MODEL_INPUTS && which[width] >= 0;
        for (int k = 1; fine && k < width; k++) {
            fine = which[k] != which[width];
        }
        if (!fine) {
            (void)fclose(file);
            return complain(width == 0 ? "the first column must be `time`, not" : "this is no input, or it is named twice:",
                            name);
        }
    }
    int code = width > 0 ? samples(q, file, which, width, most) : complain("there are no inputs in", q->inputs);
    (void)fclose(file);
    return code;
}

static int listed(void)
{
    for (int i = 0; i < MODEL_TUNABLES; i++) {
        (void)printf("tunable %s [%s]\n", MODEL_plan.tunable[i].name, MODEL_plan.tunable[i].unit);
    }
    for (int i = 0; i < MODEL_INPUTS; i++) {
        (void)printf("input %s [%s]\n", MODEL_plan.input[i].name, MODEL_plan.input[i].unit);
    }
    for (int i = 0; i < MODEL_OUTPUTS; i++) {
        (void)printf("output %s [%s]\n", MODEL_plan.variable[i].name, MODEL_plan.variable[i].unit);
    }
    return 0;
}

static int setting(request *q, const char *name, const char *value)
{
    struct {
        const char *name;
        double *to;
    } const numbers[] = {{"--start", &q->settings.start_time},
                         {"--stop", &q->settings.stop_time},
                         {"--step", &q->settings.step},
                         {"--interval", &q->settings.interval}};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        if (strcmp(name, numbers[i].name) == 0) {
            return csv_number(value, numbers[i].to) && isfinite(*numbers[i].to) ? 0 : complain("no number:", value);
        }
    }
    for (int i = AC_EULER; strcmp(name, "--solver") == 0 && i <= AC_ROS2; i++) {
        if (strcmp(value, methods[i]) == 0) {
            q->settings.method = i;
            return 0;
        }
    }
    if (strcmp(name, "--events") == 0 && (strcmp(value, "locate") == 0 || strcmp(value, "step") == 0)) {
        q->settings.locate = value[0] == 'l';
        return 0;
    }
    if (strcmp(name, "--solver") == 0 || strcmp(name, "--events") == 0) {
        return complain(name[2] == 's' ? "there is no such solver:" : "events are handled by `locate` or `step`, not:", value);
    }
    return complain("there is no such option, see --help:", name);
}

static int asked(request *q, int count, char *const words[])
{
    for (int i = 1; i < count; i++) {
        const char *word = words[i];
        const char *value = i + 1 < count ? words[i + 1] : NULL;
        int code = 0;
        if (word[0] != '-') {
            return complain("there is no such option, see --help:", word);
        }
        if (value == NULL) {
            return complain("this option needs a value:", word);
        }
        i++;
        if (strcmp(word, "-p") == 0) {
            q->table = value;
        } else if (strcmp(word, "-r") == 0) {
            q->results = value;
        } else if (strcmp(word, "-o") == 0) {
            q->rows = value;
        } else if (strcmp(word, "-t") == 0) {
            q->inputs = value;
        } else if (strcmp(word, "-u") == 0) {
            code = constant(q, value);
        } else {
            code = setting(q, word, value);
        }
        if (code != 0) {
            return code;
        }
    }
    const ac_settings *s = &q->settings;
    int fine = s->stop_time >= s->start_time && s->step > 0.0 && s->interval > 0.0 &&
               (s->stop_time - s->start_time) / fmin(s->step, s->interval) < 1e15;
    return fine ? inputs(q) : complain("the times, the step or the interval cannot be", "");
}

int main(int count, char *words[])
{
    static request q;
    static course c;
    if (count == 2 && strcmp(words[1], "--list") == 0) {
        return listed();
    }
    if (count == 2 && (strcmp(words[1], "-h") == 0 || strcmp(words[1], "--help") == 0)) {
        return fputs(usage, stdout) < 0;
    }
    ac_defaults(&MODEL_plan, &q.settings);
    q.settings.clock = ac_clock;
    q.settings.row = row;
    q.settings.warn = warn;
    q.settings.owner = &c;
    int code = asked(&q, count, words);
    if (code != 0) {
        return code;
    }
    FILE *results = q.results != NULL ? fopen(q.results, "w") : stdout;
    c.rows = q.rows != NULL ? fopen(q.rows, "w") : NULL;
    if (results == NULL || (q.rows != NULL && c.rows == NULL)) {
        return complain("cannot write", results == NULL ? q.results : q.rows);
    }
    header(results, "variant,status,time");
    if (c.rows != NULL) {
        header(c.rows, "variant,time");
    }
    long failed = all(&q, &c, results);
    int unwritten = fclose(results) != 0;
    unwritten |= c.rows != NULL && fclose(c.rows) != 0;
    if (failed < 0 || unwritten) {
        return unwritten ? complain("cannot write all results", "") : 2;
    }
    (void)fprintf(q.results != NULL ? stdout : stderr, "%ld variants, %ld failed; real-time factor %.3g; worst step %.3g s\n", c.variant, failed,
                  c.variant > 0 ? factor_sum / (double)c.variant : 0.0, longest);
    return failed > 0;
}
