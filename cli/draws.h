/* SPDX-License-Identifier: Apache-2.0 */
/* The input of `sample`: viewers and random numbers, as lines of text or raw float32. */
#ifndef NDOTL_CLI_DRAWS_H
#define NDOTL_CLI_DRAWS_H
#include "directions.h"

#include <stdint.h>

/* Unit vectors wo and three numbers in [0, 1) each, the first n of each array. */
typedef struct {
    size_t n;
    float wo[3][CLI_BATCH], u[3][CLI_BATCH];
} cli_draws;

typedef struct cli_draw_source cli_draw_source;

/* Opens a file; NULL or "-" is stdin. seed: of the random numbers of rows that give none.
   0 and *source, which the caller closes; or 1 after a message. */
int cli_draws_open(const char *verb, const char *path, bool raw, uint64_t seed,
                   cli_draw_source **source);
void cli_draws_close(cli_draw_source *source);

/* The next rows: fewer than a batch where nothing more is there yet, n = 0 at the end. 0, or 1
   after a message that names the file and the row; rows before a malformed one come first. */
int cli_draws_next(cli_draw_source *source, cli_draws *draws);

#endif
