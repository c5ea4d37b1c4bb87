/* SPDX-License-Identifier: Apache-2.0 */
#include "base/threads.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

typedef struct {
    const nd_jobs *jobs;
    atomic_size_t next;
    atomic_bool stopped;
    pthread_mutex_t lock; /* of finished and of the calls of jobs->finished */
    size_t finished;
} pool;

typedef struct {
    pool *pool;
    int thread;
    pthread_t id;
} worker;

static void *work_off(void *argument) {
    worker *w = argument;
    pool *p = w->pool;
    while (!atomic_load(&p->stopped)) {
        size_t item = atomic_fetch_add(&p->next, 1);
        if (item >= p->jobs->count) break;
        p->jobs->work(p->jobs->context, w->thread, item);
        pthread_mutex_lock(&p->lock);
        p->finished++;
        if (p->jobs->finished && !p->jobs->finished(p->jobs->context, p->finished))
            atomic_store(&p->stopped, true);
        pthread_mutex_unlock(&p->lock);
    }
    return NULL;
}

bool nd_jobs_run(const nd_jobs *jobs, int threads) {
    pool p = {.jobs = jobs, .lock = PTHREAD_MUTEX_INITIALIZER};
    if (threads > ND_MOST_THREADS) threads = ND_MOST_THREADS;
    if ((size_t)threads > jobs->count) threads = (int)jobs->count;
    worker *others = threads > 1 ? malloc((size_t)threads * sizeof *others) : NULL;
    int started = 0;
    for (int i = 1; others && i < threads; i++) {
        others[started] = (worker){.pool = &p, .thread = i};
        if (pthread_create(&others[started].id, NULL, work_off, &others[started]) == 0) started++;
    }
    work_off(&(worker){.pool = &p, .thread = 0});
    for (int i = 0; i < started; i++) pthread_join(others[i].id, NULL);
    free(others);
    pthread_mutex_destroy(&p.lock);
    return p.finished == jobs->count;
}

int nd_processors(void) {
    long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > ND_MOST_THREADS ? ND_MOST_THREADS : (int)n;
}

double nd_clock(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
