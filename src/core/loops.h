/* SPDX-License-Identifier: Apache-2.0 */
/* How kernels.c and terms.c write a loop: names of what it reads, and parameters per lane. */
#ifndef ND_CORE_LOOPS_H
#define ND_CORE_LOOPS_H
#include "core/kernels.h"

#include <string.h>

/* Loops run over whole groups of ND_GROUP lanes: a multiple that compilers see needs no code for a
   rest, which would triple the size of the library; eval.c fills the last group up.
   `restrict` on local pointers does not help compilers here; the pragma does.
   NDL_PLAIN_LOOPS: one lane after the other, the reference that the vector builds are measured
   against. */
#ifdef NDL_PLAIN_LOOPS
enum { ND_GROUP = 1 };
#define LANES for (size_t i = 0; i < n; i++)
#else
enum { ND_GROUP = 16 };
#define LANES _Pragma("omp simd") for (size_t i = 0; i < n; i++)
#endif

#define DIRECTIONS(q)                                                                              \
    const size_t n = (q)->n & ~(size_t)(ND_GROUP - 1);                                             \
    const float *ix = (q)->wi[0], *iy = (q)->wi[1], *iz = (q)->wi[2];                              \
    const float *ox = (q)->wo[0], *oy = (q)->wo[1], *oz = (q)->wo[2];
#define OUTPUTS(q) float *r = (q)->out[0], *g = (q)->out[1], *b = (q)->out[2];
#define WI v3(ix[i], iy[i], iz[i])
#define WO v3(ox[i], oy[i], oz[i])

/* For a model's parameter list: the struct of its streams, and reading a lane of them. */
#define DEFINE_STREAMS(model, PARAMS)                                                              \
    typedef struct {                                                                               \
        PARAMS(POINTER)                                                                            \
        const void *fields;                                                                        \
    } model##_streams;                                                                             \
    FN model##_streams model##_open(nd_inputs in) {                                                \
        typedef model##_p owner;                                                                   \
        model##_streams s;                                                                         \
        PARAMS(OPEN)                                                                               \
        s.fields = in.fields;                                                                      \
        return s;                                                                                  \
    }                                                                                              \
    FN model##_p model##_lane(model##_p p, model##_streams s, size_t i) {                          \
        PARAMS(LOAD)                                                                               \
        return p;                                                                                  \
    }

#define STREAM_OF(key) in.streams[offsetof(owner, key) / sizeof(float)]

#define POINTER(kind, ...) POINTER_##kind(__VA_ARGS__)
#define OPEN(kind, ...) OPEN_##kind(__VA_ARGS__)
#define LOAD(kind, ...) LOAD_##kind(__VA_ARGS__)

#define POINTER_NUM(key, ...) const float *key;
#define OPEN_NUM(key, ...) s.key = STREAM_OF(key);
#define LOAD_NUM(key, ...) p.key = s.key[i];
#define POINTER_RGB(key, ...) const float *key##_x, *key##_y, *key##_z;
#define OPEN_RGB(key, ...)                                                                         \
    s.key##_x = STREAM_OF(key.x);                                                                  \
    s.key##_y = STREAM_OF(key.y);                                                                  \
    s.key##_z = STREAM_OF(key.z);
#define LOAD_RGB(key, ...) p.key = v3(s.key##_x[i], s.key##_y[i], s.key##_z[i]);

#define POINTER_NUM_ABOVE POINTER_NUM
#define OPEN_NUM_ABOVE OPEN_NUM
#define LOAD_NUM_ABOVE LOAD_NUM
#define POINTER_ANGLE POINTER_NUM
#define OPEN_ANGLE OPEN_NUM
#define LOAD_ANGLE LOAD_NUM
#define POINTER_HIDDEN POINTER_NUM
#define OPEN_HIDDEN OPEN_NUM
#define LOAD_HIDDEN LOAD_NUM
#define POINTER_RGB_ABOVE POINTER_RGB
#define OPEN_RGB_ABOVE OPEN_RGB
#define LOAD_RGB_ABOVE LOAD_RGB

/* Tables stay uniform; choices and spellings are no fields. */
#define POINTER_RAMP(...)
#define OPEN_RAMP(...)
#define LOAD_RAMP(...)
#define POINTER_TABLE2(...)
#define OPEN_TABLE2(...)
#define LOAD_TABLE2(...)
#define POINTER_CHOICE(...)
#define OPEN_CHOICE(...)
#define LOAD_CHOICE(...)
#define POINTER_SPELL(...)
#define OPEN_SPELL(...)
#define LOAD_SPELL(...)
#define POINTER_SPELL_ABOVE(...)
#define OPEN_SPELL_ABOVE(...)
#define LOAD_SPELL_ABOVE(...)
#define POINTER_SPELL_ANGLE(...)
#define OPEN_SPELL_ANGLE(...)
#define LOAD_SPELL_ANGLE(...)
#define POINTER_SPELL_CHOICE(...)
#define OPEN_SPELL_CHOICE(...)
#define LOAD_SPELL_CHOICE(...)
#define POINTER_SPELL_WORD(...)
#define OPEN_SPELL_WORD(...)
#define LOAD_SPELL_WORD(...)
#define POINTER_GROUP(...)
#define OPEN_GROUP(...)
#define LOAD_GROUP(...)

/* What a loop with uniform parameters reads before it starts, and at lane i; and one with
   parameters per lane. */
#define UNIFORM_FIELDS(model)                                                                      \
    model##_p p;                                                                                   \
    memcpy(&p, in.fields, sizeof p);
#define UNIFORM_LANE(model)
#define LANES_FIELDS(model)                                                                        \
    model##_p all;                                                                                 \
    memcpy(&all, in.fields, sizeof all);                                                           \
    model##_streams streams = model##_open(in);
#define LANES_LANE(model) model##_p p = model##_lane(all, streams, i);

/* A kernel that stores a colour; MODE is UNIFORM or LANES. */
#define COLOR_KERNEL(MODE, name, model, function)                                                  \
    static void name(nd_inputs in, const nd_batch *q) {                                            \
        DIRECTIONS(q)                                                                              \
        OUTPUTS(q)                                                                                 \
        MODE##_FIELDS(model)                                                                       \
        LANES {                                                                                    \
            MODE##_LANE(model)                                                                     \
            vec3 f = function(p, WI, WO);                                                          \
            r[i] = f.x;                                                                            \
            g[i] = f.y;                                                                            \
            b[i] = f.z;                                                                            \
        }                                                                                          \
    }

#endif
