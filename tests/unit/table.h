/* SPDX-License-Identifier: Apache-2.0 */
/* Reader of the tables of this folder: lines `left => right`, '#' and the empty line are skipped,
   \\n in the left part is a line break. */
#ifndef UNIT_TABLE_H
#define UNIT_TABLE_H
#include "ndl_test.h"

typedef struct { char left[1024], right[1024]; int number; } table_row;

static inline FILE *open_table(const char *name) {
    char path[1024];
    const char *source = getenv("NDOTL_SOURCE");
    snprintf(path, sizeof path, "%s/tests/unit/%s", source ? source : ".", name);
    FILE *file = fopen(path, "r");
    if (!file) fail_msg("%s: cannot be opened", path);
    return file;
}

/* The next row; 0 at the end, where the file is closed. */
static inline int next_row(FILE *file, table_row *row) {
    char line[1024];
    while (fgets(line, sizeof line, file)) {
        row->number++;
        line[strcspn(line, "\n")] = '\0';
        char *arrow = strstr(line, " => ");
        if (line[0] == '\0' || (line[0] == '#' && !arrow)) continue;
        if (!arrow) fail_msg("line %d: no =>", row->number);
        *arrow = '\0';
        snprintf(row->left, sizeof row->left, "%s", line);
        snprintf(row->right, sizeof row->right, "%s", arrow + 4);
        for (char *s; (s = strstr(row->left, "\\n")) != NULL;) {
            *s = '\n';
            memmove(s + 1, s + 2, strlen(s + 2) + 1);
        }
        return 1;
    }
    fclose(file);
    return 0;
}

#endif
