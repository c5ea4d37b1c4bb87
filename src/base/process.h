/* SPDX-License-Identifier: Apache-2.0 */
/* Child processes with limits, for code that reads files nobody vouches for; and interruption. */
#ifndef ND_BASE_PROCESS_H
#define ND_BASE_PROCESS_H
#include <stdbool.h>
#include <stddef.h>

/* 0 means no limit. */
typedef struct {
    double seconds; /* of wall clock, and of CPU time */
    size_t memory;  /* bytes of address space beyond what the caller has; not under sanitizers */
    size_t output;  /* bytes that the child may write */
} nd_limits;

typedef enum {
    ND_CHILD_DONE,        /* work() returned; code is its result */
    ND_CHILD_CRASHED,     /* a signal ended it; code is the signal */
    ND_CHILD_TOO_SLOW,    /* the time limit ended it */
    ND_CHILD_TOO_LONG,    /* it wrote more than allowed */
    ND_CHILD_INTERRUPTED, /* nd_interrupted() became true */
    ND_CHILD_NOT_STARTED  /* no process, pipe or memory */
} nd_child_end;

typedef struct {
    nd_child_end end;
    int code;
    unsigned char *bytes; /* what it wrote, owned by the caller (free); NULL if nothing */
    size_t count;
} nd_child;

/* Runs work(context, out) in a child process and collects what it writes to the descriptor `out`
   (nd_child_write). The child sees a copy of the caller's memory; its standard streams are
   silent. Returns when the child has ended, whatever way. */
nd_child nd_child_run(int (*work)(void *context, int out), void *context, nd_limits limits);

/* Writes n bytes from the child to the caller; false once nobody reads. */
bool nd_child_write(int out, const void *bytes, size_t n);

/* From now on SIGINT, SIGTERM and SIGHUP set a flag instead of ending the process, and a write
   beyond the file size limit fails instead of killing. Meant for programs, not for libraries. */
void nd_interrupts_catch(void);
bool nd_interrupted(void);

/* Whether a person reads stderr. */
bool nd_stderr_is_terminal(void);

#endif
