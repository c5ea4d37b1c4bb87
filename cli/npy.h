/* SPDX-License-Identifier: Apache-2.0 */
/* NumPy's .npy files of float32 and float64. */
#ifndef NDOTL_CLI_NPY_H
#define NDOTL_CLI_NPY_H
#include <stdbool.h>
#include <stddef.h>

enum { CLI_NPY_MAGIC = 6, CLI_NPY_HEADER = 128 };

/* A two-dimensional view of an array in memory. */
typedef struct {
    const unsigned char *data;
    size_t rows, columns;
    size_t item; /* bytes of one number: 4 or 8 */
    bool by_columns;
} cli_npy;

/* Whether n bytes begin like a .npy file; so does the beginning of its magic. */
bool cli_npy_begins(const char *s, size_t n);

/* Views the n bytes of a file as rows of so many columns: its shape is (rows, columns), (columns,)
   or (rows, a, b) with a b = columns. NULL, or what is wrong. */
const char *cli_npy_view(const char *s, size_t n, size_t columns, cli_npy *a);

double cli_npy_value(const cli_npy *a, size_t row, size_t column);

/* The header of a float32 array of shape (rows, columns), or (rows,) for one column. */
void cli_npy_header(size_t rows, size_t columns, char to[CLI_NPY_HEADER]);

#endif
