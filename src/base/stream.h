/* SPDX-License-Identifier: Apache-2.0 */
/* Bytes from and to files without buffering in between. Failures leave the reason in errno. */
#ifndef ND_BASE_STREAM_H
#define ND_BASE_STREAM_H
#include <stdbool.h>
#include <stddef.h>

enum { ND_STDIN = 0, ND_STDOUT = 1, ND_STDERR = 2 };

/* Opens a file for reading: its number, or -1. */
int nd_stream_open(const char *path);
void nd_stream_close(int stream);

/* Reads what is there, at most n > 0 bytes, waiting for the first: bytes read, 0 at the end, -1
   on failure. */
ptrdiff_t nd_stream_read(int stream, void *to, size_t n);

/* Writes all n bytes; false on failure. */
bool nd_stream_write(int stream, const void *s, size_t n);

/* From now on a write to a closed pipe fails with EPIPE instead of ending the process. */
void nd_stream_survive_closed_pipes(void);

#endif
