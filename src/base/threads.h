/* SPDX-License-Identifier: Apache-2.0 */
/* Numbered items worked off by several threads, and the clock. */
#ifndef ND_BASE_THREADS_H
#define ND_BASE_THREADS_H
#include <stdbool.h>
#include <stddef.h>

enum { ND_MOST_THREADS = 1024 };

typedef struct {
    size_t count; /* items 0 .. count - 1, started in order */
    void (*work)(void *context, int thread, size_t item); /* thread: 0 .. threads - 1 */
    /* After each item, one caller at a time; false stops. May be NULL. */
    bool (*finished)(void *context, size_t items);
    void *context;
} nd_jobs;

/* Works off all items with at most `threads` threads, the caller's among them, and fewer where the
   system gives fewer. What an item computes may not depend on the thread, so that the result is the
   same for any number of them. False when finished() stopped it. */
bool nd_jobs_run(const nd_jobs *jobs, int threads);

/* Processors that this process may use, 1 or more. */
int nd_processors(void);

/* Seconds since some moment in the past; never runs backwards. */
double nd_clock(void);

#endif
