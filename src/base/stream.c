/* SPDX-License-Identifier: Apache-2.0 */
#include "base/stream.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

/* Some systems refuse longer reads and writes than a signed 32-bit number. */
enum { MOST_AT_ONCE = 1 << 30 };

int nd_stream_open(const char *path) {
    int stream;
    do
        stream = open(path, O_RDONLY | O_CLOEXEC);
    while (stream < 0 && errno == EINTR);
    return stream;
}

void nd_stream_close(int stream) {
    close(stream);
}

ptrdiff_t nd_stream_read(int stream, void *to, size_t n) {
    ptrdiff_t got;
    do
        got = read(stream, to, n < MOST_AT_ONCE ? n : MOST_AT_ONCE);
    while (got < 0 && errno == EINTR);
    return got;
}

bool nd_stream_write(int stream, const void *s, size_t n) {
    const char *at = s;
    while (n) {
        ptrdiff_t put = write(stream, at, n < MOST_AT_ONCE ? n : MOST_AT_ONCE);
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) return false;
        at += put;
        n -= (size_t)put;
    }
    return true;
}

void nd_stream_survive_closed_pipes(void) {
    signal(SIGPIPE, SIG_IGN);
}
