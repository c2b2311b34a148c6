/* Tables of numbers as text: one line at a time, fields separated by commas, quoted where they hold one. */
#ifndef ACAUSAL_CSV_H
#define ACAUSAL_CSV_H

#include <stdio.h>

/* Reads a line into `line`, without its end. 1: read, 0: no more, -1: longer than `size`. Empty lines are left out. */
int csv_line(FILE *file, char *line, int size);
/* The next field of a line, which is changed; NULL after the last. */
char *csv_field(char **rest);
/* A text as a field. */
void csv_text(FILE *file, const char *text);
/* 1 where the whole text is a number. */
int csv_number(const char *text, double *value);

#endif
