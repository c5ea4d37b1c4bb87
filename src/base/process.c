/* SPDX-License-Identifier: Apache-2.0 */
#include "base/process.h"

#include "base/threads.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/* The shadow memory of a sanitizer needs terabytes of address space. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LIMITS_MEMORY 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
#define LIMITS_MEMORY 0
#endif
#endif
#ifndef LIMITS_MEMORY
#define LIMITS_MEMORY 1
#endif

static volatile sig_atomic_t interrupted;

static void on_interrupt(int number) {
    (void)number;
    interrupted = 1;
}

void nd_interrupts_catch(void) {
    struct sigaction action = {.sa_handler = on_interrupt};
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGHUP, &action, NULL);
    action.sa_handler = SIG_IGN;
    sigaction(SIGXFSZ, &action, NULL);
}

bool nd_interrupted(void) {
    return interrupted != 0;
}

bool nd_stderr_is_terminal(void) {
    return isatty(STDERR_FILENO) == 1;
}

bool nd_child_write(int out, const void *bytes, size_t n) {
    const unsigned char *at = bytes;
    while (n) {
        ssize_t written = write(out, at, n);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        at += written;
        n -= (size_t)written;
    }
    return true;
}

/* Bytes of address space in use; 0 where the system does not say. */
static size_t address_space(void) {
    char text[32] = {0};
    int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    if (file < 0) return 0;
    ssize_t n = read(file, text, sizeof text - 1);
    close(file);
    size_t pages = 0;
    for (ssize_t i = 0; i < n && text[i] >= '0' && text[i] <= '9'; i++)
        pages = 10 * pages + (size_t)(text[i] - '0');
    long page = sysconf(_SC_PAGESIZE);
    return page > 0 ? pages * (size_t)page : 0;
}

static void lower_limit(int resource, rlim_t value) {
    struct rlimit limit;
    if (getrlimit(resource, &limit) != 0) return;
    if (limit.rlim_max != RLIM_INFINITY && limit.rlim_max < value) value = limit.rlim_max;
    limit.rlim_cur = limit.rlim_max = value;
    setrlimit(resource, &limit);
}

static void restrict_child(nd_limits limits) {
    lower_limit(RLIMIT_CORE, 0);
    if (limits.seconds > 0.0) lower_limit(RLIMIT_CPU, (rlim_t)limits.seconds + 1);
    if (LIMITS_MEMORY && limits.memory) lower_limit(RLIMIT_AS, address_space() + limits.memory);
    static const int defaults[] = {SIGINT, SIGTERM, SIGHUP, SIGXFSZ};
    struct sigaction action = {.sa_handler = SIG_DFL};
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof defaults / sizeof *defaults; i++)
        sigaction(defaults[i], &action, NULL);
    int nothing = open("/dev/null", O_RDWR);
    for (int i = 0; nothing >= 0 && i < 3; i++) dup2(nothing, i);
}

static bool append(nd_child *child, size_t *room, const unsigned char *bytes, size_t n) {
    if (*room - child->count < n) {
        size_t wanted = *room ? 2 * *room : (size_t)1 << 16;
        while (wanted - child->count < n) wanted *= 2;
        unsigned char *grown = realloc(child->bytes, wanted);
        if (!grown) return false;
        child->bytes = grown;
        *room = wanted;
    }
    memcpy(child->bytes + child->count, bytes, n);
    child->count += n;
    return true;
}

/* Reads until the child closes its end; anything but ND_CHILD_DONE means that it is to be ended. */
static nd_child_end collect(nd_child *child, int in, nd_limits limits) {
    enum { STEP = 1 << 16, PATIENCE_MS = 100 };
    unsigned char *step = malloc(STEP);
    size_t room = 0;
    double deadline = nd_clock() + limits.seconds;
    nd_child_end end = step ? ND_CHILD_DONE : ND_CHILD_NOT_STARTED;
    while (end == ND_CHILD_DONE) {
        struct pollfd wait = {.fd = in, .events = POLLIN};
        int ready = poll(&wait, 1, PATIENCE_MS);
        if (nd_interrupted()) {
            end = ND_CHILD_INTERRUPTED;
        } else if (limits.seconds > 0.0 && nd_clock() > deadline) {
            end = ND_CHILD_TOO_SLOW;
        } else if (ready > 0) {
            ssize_t n = read(in, step, STEP);
            if (n == 0) break;
            if (n < 0 && errno != EINTR && errno != EAGAIN) break;
            if (n < 0) continue;
            if (limits.output && child->count + (size_t)n > limits.output) end = ND_CHILD_TOO_LONG;
            else if (!append(child, &room, step, (size_t)n)) end = ND_CHILD_NOT_STARTED;
        }
    }
    free(step);
    return end;
}

static void reap(nd_child *child, pid_t pid) {
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {}
    if (child->end != ND_CHILD_DONE) return;
    if (WIFEXITED(status)) {
        child->code = WEXITSTATUS(status);
    } else {
        child->code = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
        child->end = child->code == SIGXCPU ? ND_CHILD_TOO_SLOW : ND_CHILD_CRASHED;
    }
}

nd_child nd_child_run(int (*work)(void *context, int out), void *context, nd_limits limits) {
    nd_child child = {.end = ND_CHILD_NOT_STARTED};
    int ends[2];
    if (pipe(ends) != 0) return child;
    pid_t pid = fork();
    if (pid == 0) {
        close(ends[0]);
        restrict_child(limits);
        _exit(work(context, ends[1]));
    }
    close(ends[1]);
    if (pid > 0) {
        child.end = collect(&child, ends[0], limits);
        if (child.end != ND_CHILD_DONE) kill(pid, SIGKILL);
        reap(&child, pid);
    }
    close(ends[0]);
    if (child.end != ND_CHILD_DONE) {
        free(child.bytes);
        child.bytes = NULL;
        child.count = 0;
    }
    return child;
}
