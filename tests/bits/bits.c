/* SPDX-License-Identifier: Apache-2.0 */
/* The same bits everywhere. Hashes the results of every registered model with its defaults and of
   the materials of a list, and compares them between the instruction sets of this machine; with
   NDOTL_BITS_REFERENCE also with the hashes that another build has written.

       bits MATERIALS OUTPUT [scalar]

   scalar: the scalar kernels only, for builds that are too slow for all.
   Lines of MATERIALS: number of inputs, material. Lines of OUTPUT: hash of brdf, hash of brdf_cos,
   number of inputs, material. */
#include <ndotl/ndotl.h>

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CHUNK = 4096, LONGEST_LINE = 512, DEFAULT_INPUTS = 1000000 };

static const char *const ISAS[] = {"scalar", "x86-64", "x86-64-v3", "x86-64-v4", "neon"};
enum { ISA_COUNT = sizeof ISAS / sizeof ISAS[0] };

/* How many of ISAS are run. */
static int isa_count = ISA_COUNT;

typedef struct { float wi[3][CHUNK], wo[3][CHUNK]; } batch;

/* xorshift64*; a fresh state for every row, so that rows do not depend on each other. */
static uint64_t next(uint64_t *state) {
    uint64_t x = *state;
    x ^= x >> 12;
    x ^= x << 25;
    x ^= x >> 27;
    *state = x;
    return x * 0x2545F4914F6CDD1DULL;
}

static float uniform(uint64_t *state) {
    return (float)(next(state) >> 40) * 0x1p-24f;
}

/* A unit vector; one in twenty below the horizon, one in eight within 1e-3 of it. Only correctly
   rounded operations, so that the inputs are the same everywhere, too. */
static void direction(uint64_t *state, float *x, float *y, float *z) {
    float px, py, pz, length;
    do {
        px = 2.0f * uniform(state) - 1.0f;
        py = 2.0f * uniform(state) - 1.0f;
        pz = 1.05f * uniform(state) - 0.05f;
        length = px * px + py * py + pz * pz;
    } while (length > 1.0f || length < 0.01f);
    if (next(state) >> 61 == 0) {
        pz *= 1e-3f;
        length = px * px + py * py + pz * pz;
    }
    length = sqrtf(length);
    *x = px / length;
    *y = py / length;
    *z = pz / length;
}

static void fill(uint64_t *state, batch *b) {
    for (size_t i = 0; i < CHUNK; i++) {
        direction(state, &b->wi[0][i], &b->wi[1][i], &b->wi[2][i]);
        direction(state, &b->wo[0][i], &b->wo[1][i], &b->wo[2][i]);
    }
}

/* FNV-1a over the bits; -0 and +0 differ, as they should. */
static uint64_t hash_floats(uint64_t hash, const float *values, size_t n) {
    for (size_t i = 0; i < n; i++) {
        uint32_t bits;
        memcpy(&bits, &values[i], sizeof bits);
        hash = (hash ^ bits) * 0x100000001B3ULL;
    }
    return hash;
}

typedef void evaluator(const ndl_material *, size_t, ndl_vec3_n, ndl_vec3_n, ndl_rgb_n);
static evaluator *const EVALUATORS[] = {ndl_brdf_n, ndl_brdf_cos_n};
static const char *const QUANTITIES[] = {"brdf", "brdf_cos"};

static void evaluate(const ndl_material *m, int quantity, size_t n, const batch *b,
                     float rgb[3][CHUNK]) {
    ndl_vec3_n wi = {b->wi[0], b->wi[1], b->wi[2]}, wo = {b->wo[0], b->wo[1], b->wo[2]};
    ndl_rgb_n out = {rgb[0], rgb[1], rgb[2]};
    EVALUATORS[quantity](m, n, wi, wo, out);
}

/* The instruction sets whose bits for this batch are not those of `want`, as a bit set. */
static unsigned other_bits(const ndl_material *m, int quantity, size_t n, const batch *b,
                           float want[3][CHUNK]) {
    static float got[3][CHUNK];
    unsigned different = 0;
    for (int i = 1; i < isa_count; i++) {
        if (ndl_use_isa(ISAS[i]) != NDL_OK) {
            continue;
        }
        evaluate(m, quantity, n, b, got);
        for (int c = 0; c < 3; c++) {
            if (memcmp(got[c], want[c], n * sizeof(float)) != 0) {
                different |= 1u << i;
            }
        }
    }
    return different;
}

/* Hashes both quantities with the scalar kernels; the number of instruction sets that differ. */
static int hash_material(const ndl_material *m, const char *text, size_t n, uint64_t hash[2]) {
    static batch b;
    static float rgb[3][CHUNK];
    uint64_t state = 0x9E3779B97F4A7C15ULL;
    unsigned different[2] = {0, 0};
    int wrong = 0;
    hash[0] = hash[1] = 0xCBF29CE484222325ULL;
    for (size_t done = 0; done < n; done += CHUNK) {
        size_t count = n - done < CHUNK ? n - done : CHUNK;
        fill(&state, &b);
        for (int quantity = 0; quantity < 2; quantity++) {
            ndl_use_isa("scalar");
            evaluate(m, quantity, count, &b, rgb);
            different[quantity] |= other_bits(m, quantity, count, &b, rgb);
            for (int c = 0; c < 3; c++) {
                hash[quantity] = hash_floats(hash[quantity], rgb[c], count);
            }
        }
    }
    for (int i = 0; i < 2 * ISA_COUNT; i++) {
        if (different[i / ISA_COUNT] >> i % ISA_COUNT & 1) {
            printf("%s of %s: %s has other bits than scalar\n", QUANTITIES[i / ISA_COUNT], text,
                   ISAS[i % ISA_COUNT]);
            wrong++;
        }
    }
    return wrong;
}

/* Writes the hashes of one material; the number of differences. */
static int one_material(const char *text, size_t n, FILE *output) {
    ndl_error error;
    uint64_t hash[2];
    ndl_material *m = ndl_material_parse(text, &error);
    if (!m) {
        printf("%s: column %d: %s\n", text, error.column, error.text);
        return 1;
    }
    int wrong = hash_material(m, text, n, hash);
    ndl_material_free(m);
    fprintf(output, "%016llx %016llx %zu %s\n", (unsigned long long)hash[0],
            (unsigned long long)hash[1], n, text);
    return wrong;
}

/* Every model, then every line of the list; the number of differences. */
static int all_materials(FILE *list, FILE *output) {
    char line[LONGEST_LINE];
    int wrong = 0;
    for (size_t i = 0; i < ndl_model_count(); i++) {
        wrong += one_material(ndl_model_name(i), DEFAULT_INPUTS, output);
    }
    while (fgets(line, sizeof line, list)) {
        char *material;
        size_t n = strtoul(line, &material, 10);
        line[strcspn(line, "\n")] = 0;
        if (line[0] != '#' && line[0]) {
            wrong += one_material(material + 1, n, output);
        }
    }
    return wrong;
}

/* Prints the lines in which two files differ; the number of them. */
static int compare_files(FILE *ours, FILE *reference) {
    char a[LONGEST_LINE], b[LONGEST_LINE];
    int wrong = 0;
    for (;;) {
        char *more = fgets(a, sizeof a, ours), *other = fgets(b, sizeof b, reference);
        if (!more && !other) {
            return wrong;
        }
        if (!more || !other || strcmp(a, b) != 0) {
            printf("differs from the reference:\n  %s  %s", more ? a : "\n", other ? b : "\n");
            wrong++;
        }
    }
}

static FILE *open_or_exit(const char *name, const char *mode) {
    FILE *file = fopen(name, mode);
    if (!file) {
        fprintf(stderr, "bits: %s: cannot be opened\n", name);
        exit(2);
    }
    return file;
}

int main(int argc, char **argv) {
    if (argc < 3) {
        fprintf(stderr, "usage: bits MATERIALS OUTPUT [scalar]\n");
        return 2;
    }
    isa_count = argc > 3 ? 1 : ISA_COUNT;
    FILE *list = open_or_exit(argv[1], "r"), *output = open_or_exit(argv[2], "w+");
    int wrong = all_materials(list, output);
    const char *name = getenv("NDOTL_BITS_REFERENCE");
    if (name && *name) {
        FILE *reference = open_or_exit(name, "r");
        rewind(output);
        wrong += compare_files(output, reference);
        fclose(reference);
    }
    printf("%d differences%s%s\n", wrong, name ? ", also from " : "", name ? name : "");
    fclose(list);
    return fclose(output) != 0 || wrong != 0;
}
