/* SPDX-License-Identifier: Apache-2.0 */
/* Pairs of directions from a stream: lines of text, raw float32 or a .npy array. */
#ifndef NDOTL_CLI_DIRECTIONS_H
#define NDOTL_CLI_DIRECTIONS_H
#include "ndotl/ndotl.h"

#include <stdbool.h>
#include <stddef.h>

enum { CLI_BATCH = 4096 };

/* Unit vectors, the first n of each array. */
typedef struct {
    size_t n;
    float ix[CLI_BATCH], iy[CLI_BATCH], iz[CLI_BATCH];
    float ox[CLI_BATCH], oy[CLI_BATCH], oz[CLI_BATCH];
} cli_pairs;

/* Makes the next pair of six numbers wi.x ... wo.z, or of four angles in degrees theta_i phi_i
   theta_o phi_o. *off becomes the length that is farthest from 1. NULL, or what is wrong. */
const char *cli_pairs_add(cli_pairs *to, const double *v, bool angles, double *off);

/* The numbers of one line, without its end: separated by blanks, tabs or commas, # starts a
   comment. The count found, 0 for a line without numbers; -1 for a malformed line, with *what, the
   place *at and the bytes n that are to blame. At most `most` are stored, more are counted. */
int cli_line_numbers(const char *s, const char *end, double *v, int most, const char **what,
                     const char **at, size_t *n);

typedef struct cli_source cli_source;

/* Opens a file; NULL or "-" is stdin. raw: float32 unless the data begins like a .npy file.
   0 and *source, which the caller closes; or 1 after a message. */
int cli_source_open(const char *verb, const char *path, bool raw, bool angles, cli_source **source);
void cli_source_close(cli_source *source);

/* Whether the data turned out to be a .npy array. */
bool cli_source_is_npy(const cli_source *source);

/* The next pairs: fewer than a batch where nothing more is there yet, n = 0 at the end. 0, or 1
   after a message that names the file and the line. */
int cli_source_next(cli_source *source, cli_pairs *pairs);

#endif
