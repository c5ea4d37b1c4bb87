/* SPDX-License-Identifier: Apache-2.0 */
#include "feed.h"

#include "base/stream.h"
#include "report.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

int cli_feed_open(cli_feed *f, const char *verb, const char *path) {
    bool standard = !path || strcmp(path, "-") == 0;
    f->verb = verb;
    f->name = standard ? "stdin" : path;
    f->stream = standard ? ND_STDIN : nd_stream_open(path);
    if (f->stream >= 0) return CLI_OK;
    return cli_error(verb, CLI_FAILED, path, "cannot be opened: %s", strerror(errno));
}

void cli_feed_close(cli_feed *f) {
    if (f->stream > ND_STDIN) nd_stream_close(f->stream);
}

cli_place cli_feed_place(const cli_feed *f) {
    cli_place p;
    snprintf(p.s, sizeof p.s, "%s:%s%llu", f->name, f->raw ? " row " : "", f->row);
    return p;
}

int cli_feed_fill(cli_feed *f) {
    memmove(f->buffer, f->buffer + f->at, f->end - f->at);
    f->end -= f->at;
    f->at = 0;
    ptrdiff_t got = nd_stream_read(f->stream, f->buffer + f->end, CLI_FEED_BUFFER - f->end);
    if (got < 0)
        return cli_error(f->verb, CLI_FAILED, f->name, "cannot be read: %s", strerror(errno));
    f->at_end = got == 0;
    f->end += (size_t)got;
    return CLI_OK;
}

void cli_feed_skip_mark(cli_feed *f) {
    if (f->end - f->at >= 3 && memcmp(f->buffer + f->at, "\xef\xbb\xbf", 3) == 0) f->at += 3;
}

/* A line that does not fit into the buffer. */
static cli_fed too_long(cli_feed *f) {
    f->row++;
    cli_error(f->verb, CLI_FAILED, cli_feed_place(f).s, "the line is longer than %d bytes",
              CLI_FEED_BUFFER);
    return CLI_FEED_FAILED;
}

cli_fed cli_feed_line(cli_feed *f, bool wait, const char **line, const char **end) {
    for (;;) {
        *line = f->buffer + f->at;
        *end = memchr(*line, '\n', f->end - f->at);
        if (*end || (f->at_end && f->at < f->end)) {
            f->row++;
            f->at = *end ? (size_t)(*end - f->buffer) + 1 : f->end;
            if (!*end) *end = f->buffer + f->end;
            return CLI_FEED_ROW;
        }
        if (f->at_end || !wait) return CLI_FEED_LATER;
        if (f->end - f->at == CLI_FEED_BUFFER) return too_long(f);
        if (cli_feed_fill(f)) return CLI_FEED_FAILED;
    }
}

static double little_endian_float(const char *s) {
    const unsigned char *b = (const unsigned char *)s;
    uint32_t bits = b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
    float x;
    memcpy(&x, &bits, sizeof x);
    return (double)x;
}

cli_fed cli_feed_numbers(cli_feed *f, bool wait, int columns, double *v) {
    size_t bytes = 4 * (size_t)columns;
    while (f->end - f->at < bytes && !f->at_end) {
        if (!wait) return CLI_FEED_LATER;
        if (cli_feed_fill(f)) return CLI_FEED_FAILED;
    }
    size_t rest = f->end - f->at;
    if (!rest) return CLI_FEED_LATER;
    f->row++;
    if (rest < bytes) {
        f->at = f->end;
        cli_error(f->verb, CLI_FAILED, cli_feed_place(f).s, "cut off: %d of %d bytes are there",
                  (int)rest, (int)bytes);
        return CLI_FEED_FAILED;
    }
    for (int i = 0; i < columns; i++)
        v[i] = little_endian_float(f->buffer + f->at + 4 * i);
    f->at += bytes;
    return CLI_FEED_ROW;
}
