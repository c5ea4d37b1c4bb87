/* SPDX-License-Identifier: Apache-2.0 */
/* The results of `eval` on stdout: lines, CSV, JSON, raw float32 or .npy. */
#ifndef NDOTL_CLI_TABLE_H
#define NDOTL_CLI_TABLE_H
#include "base/text.h"
#include "directions.h"

typedef enum { CLI_LINES, CLI_CSV, CLI_JSON, CLI_RAW, CLI_NPY } cli_table_format;

typedef struct {
    const char *verb;
    cli_table_format format;
    const char *material, *quantity, *unit; /* for JSON and the header of CSV */
    size_t columns;                         /* numbers per row: 3, or 1 */
    size_t rows;                            /* written so far */
    nd_text text;                           /* not yet written */
} cli_table;

void cli_table_begin(cli_table *t);

/* Adds a row for each pair; the first `columns` of r, g, b. Lines, CSV and raw numbers leave at
   once; JSON and .npy are whole or absent. 0, or 1 after a message. */
int cli_table_add(cli_table *t, const cli_pairs *pairs, ndl_rgb_n rgb);

/* 0, or 1 after a message. */
int cli_table_end(cli_table *t);

#endif
