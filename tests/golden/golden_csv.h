/* SPDX-License-Identifier: Apache-2.0 */
/* Reader of the golden tables: lines of comma-separated cells, cells in "quotes" may hold commas,
   '#' begins a comment line, the first other line is the header. */
#ifndef GOLDEN_CSV_H
#define GOLDEN_CSV_H
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { GOLDEN_CELLS = 16, GOLDEN_LINE = 4096 };

typedef struct {
    FILE *file;
    char line[GOLDEN_LINE];
    char *cell[GOLDEN_CELLS];
    int cells, number; /* of the row: cells found, line in the file */
} golden_csv;

/* tests/golden/<name>.csv of the source tree; stops the program when it is not there. */
static inline golden_csv golden_open(const char *name) {
    golden_csv csv = {0};
    char path[1024];
    const char *source = getenv("NDOTL_SOURCE");
    snprintf(path, sizeof path, "%s/tests/golden/%s.csv", source ? source : ".", name);
    csv.file = fopen(path, "r");
    if (!csv.file) {
        fprintf(stderr, "%s: %s\n", path, strerror(errno));
        exit(1);
    }
    return csv;
}

static inline void golden_split(golden_csv *csv) {
    char *s = csv->line;
    csv->cells = 0;
    while (csv->cells < GOLDEN_CELLS) {
        bool quoted = *s == '"';
        csv->cell[csv->cells++] = s += quoted;
        s += strcspn(s, quoted ? "\"" : ",\r\n");
        char end = *s;
        if (end) *s++ = '\0';
        if (quoted && *s) end = *s++;
        if (end != ',') break;
    }
}

/* The next row, the header included; false at the end, where the file is closed. */
static inline bool golden_next(golden_csv *csv) {
    while (fgets(csv->line, sizeof csv->line, csv->file)) {
        csv->number++;
        if (csv->line[0] == '#') continue;
        golden_split(csv);
        return true;
    }
    fclose(csv->file);
    return false;
}

static inline double golden_number(const golden_csv *csv, int cell) {
    return cell < csv->cells ? strtod(csv->cell[cell], NULL) : 0.0;
}

#endif
