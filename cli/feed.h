/* SPDX-License-Identifier: Apache-2.0 */
/* Rows of an input, lines of text or raw float32, through one buffer. */
#ifndef NDOTL_CLI_FEED_H
#define NDOTL_CLI_FEED_H
#include <stdbool.h>
#include <stddef.h>

enum { CLI_FEED_BUFFER = 1 << 20 }; /* the longest line, too */

typedef struct {
    const char *verb, *name; /* for messages */
    int stream;
    bool raw, at_end;
    unsigned long long row; /* lines, or raw rows, taken so far */
    size_t at, end;         /* the unread part of the buffer */
    char buffer[CLI_FEED_BUFFER];
} cli_feed;

/* CLI_FEED_LATER: nothing more is there, at the end, or for now without waiting. */
typedef enum { CLI_FEED_ROW, CLI_FEED_LATER, CLI_FEED_FAILED } cli_fed;

/* Opens a file; NULL or "-" is stdin. The feed is all zero before. 0, or 1 after a message. */
int cli_feed_open(cli_feed *f, const char *verb, const char *path);
void cli_feed_close(cli_feed *f);

/* Reads more behind the unread part. 0, or 1 after a message. */
int cli_feed_fill(cli_feed *f);

/* A byte order mark, as some editors write it, is no part of the first line. */
void cli_feed_skip_mark(cli_feed *f);

/* The next line [*line, *end). wait: for more input, where no whole line is there yet.
   CLI_FEED_FAILED after a message. */
cli_fed cli_feed_line(cli_feed *f, bool wait, const char **line, const char **end);

/* The next `columns` little-endian floats, as doubles; otherwise like cli_feed_line. */
cli_fed cli_feed_numbers(cli_feed *f, bool wait, int columns, double *v);

/* "FILE:LINE" of the row that was taken last. */
typedef struct { char s[4200]; } cli_place;
cli_place cli_feed_place(const cli_feed *f);

#endif
