/* See csv.h. */
#include "csv.h"

#include <stdlib.h>
#include <string.h>

int csv_line(FILE *file, char *line, int size)
{
    size_t length = 0;
    int first = ftell(file) == 0;
    while (length == 0) {
        if (fgets(line, size, file) == NULL) {
            return 0;
        }
        length = strlen(line);
        if (length + 1 == (size_t)size && line[length - 1] != '\n') {
            return -1;
        }
        while (length > 0 && (line[length - 1] == '\n' || line[length - 1] == '\r')) {
            line[--length] = '\0';
        }
        if (first && length > 2 && strncmp(line, "\357\273\277", 3) == 0) { /* the mark that some programs put before UTF-8 */
            length -= 3;
            memmove(line, line + 3, length + 1);
        }
        first = 0;
    }
    return 1;
}

static int is_blank(char c)
{
    return c == ' ' || c == '\t';
}

static char *quoted(char **rest)
{
    char *from = *rest + 1;
    char *start = from;
    char *to = from;
    while (*from != '\0' && (*from != '"' || from[1] == '"')) {
        from += *from == '"' ? 1 : 0;
        *to++ = *from++;
    }
    from += *from == '"' ? 1 : 0;
    while (is_blank(*from)) {
        from++;
    }
    *rest = *from == ',' ? from + 1 : NULL;
    *to = '\0';
    return start;
}

char *csv_field(char **rest)
{
    char *start = *rest;
    if (start == NULL) {
        return NULL;
    }
    while (is_blank(*start)) {
        start++;
    }
    if (*start == '"') {
        *rest = start;
        return quoted(rest);
    }
    char *end = strchr(start, ',');
    *rest = end != NULL ? end + 1 : NULL;
    end = end != NULL ? end : start + strlen(start);
    while (end > start && is_blank(end[-1])) {
        end--;
    }
    *end = '\0';
    return start;
}

void csv_text(FILE *file, const char *text)
{
    if (strpbrk(text, ",\"\n") == NULL) {
        (void)fputs(text, file);
        return;
    }
    (void)fputc('"', file);
    for (; *text != '\0'; text++) {
        if (*text == '"') {
            (void)fputc('"', file);
        }
        (void)fputc(*text == '\n' ? ' ' : *text, file);
    }
    (void)fputc('"', file);
}

int csv_number(const char *text, double *value)
{
    char *end = NULL;
    *value = strtod(text, &end);
    return end != text && *end == '\0';
}
