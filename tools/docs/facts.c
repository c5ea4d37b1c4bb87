/* SPDX-License-Identifier: Apache-2.0 */
/* What the pages of docs/models need and the program does not print: the manuals of the microfacet
   terms, and directional albedos of the materials on standard input. As JSON. */
#include <math.h>
#include <ndotl/ndotl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shade/prelude_c.h"

#include "shade/math.h"

#include "shade/fresnel.h"
#include "shade/masking.h"
#include "shade/ndf.h"

static void put(const char *key, const char *text, const char *end) {
    printf("\"%s\":\"", key);
    for (; *text; text++)
        printf(*text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
    printf("\"%s", end);
}

#define TERM(M, word, what, formula, notes, source)                                                \
    printf("{");                                                                                   \
    put("word", #word, ",");                                                                       \
    put("what", what, ",");                                                                        \
    put("formula", formula, ",");                                                                  \
    put("notes", notes, ",");                                                                      \
    put("source", source, "},\n");

/* E at NoV 1, .5, .1, .01 of the first channel. */
static void put_albedo(const char *text) {
    static const double cosine[] = {1.0, 0.5, 0.1, 0.01};
    ndl_error err;
    ndl_material *m = ndl_material_parse(text, &err);
    if (!m) {
        fprintf(stderr, "%s: column %d: %s\n", text, err.column, err.text);
        exit(1);
    }
    printf("[");
    for (int i = 0; i < 4; i++) {
        double c = cosine[i];
        ndl_vec3 wo = {(float)sqrt(1.0 - c * c), 0.0f, (float)c};
        printf("%.6f%s", (double)ndl_albedo(m, wo, 1e-5f, NULL).r, i < 3 ? "," : "],\n");
    }
    ndl_material_free(m);
}

int main(void) {
    char line[512];
    printf("{\"ndf\":[");
    NDF_MANUAL(TERM, )
    printf("null],\n\"masking\":[");
    MASKING_MANUAL(TERM, )
    printf("null],\n\"fresnel\":[");
    FRESNEL_MANUAL(TERM, )
    printf("null],\n\"albedo\":[");
    while (fgets(line, sizeof line, stdin)) {
        line[strcspn(line, "\n")] = '\0';
        put_albedo(line);
    }
    printf("null]}\n");
    return 0;
}
