/* SPDX-License-Identifier: Apache-2.0 */
/* Any text is a material or an error with a place; a material prints as text that parses to the
   same text and the same values. */
#include "ndotl/ndotl.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static void require(int condition) {
    if (!condition) abort();
}

static void check_error(const ndl_error *e, size_t n) {
    require(e->code > NDL_OK && e->code < NDL_STATUS_COUNT);
    require(e->column >= 0 && (size_t)e->column <= n + 1);
    require(memchr(e->text, '\0', sizeof e->text) && e->text[0]);
}

static void check_round_trip(const ndl_material *m) {
    static const ndl_vec3 wi = {0.36f, 0.48f, 0.8f}, wo = {-0.6f, 0.0f, 0.8f};
    ndl_material *again = ndl_material_parse(ndl_material_text(m), NULL);
    require(again != NULL);
    require(strcmp(ndl_material_text(again), ndl_material_text(m)) == 0);
    require(strcmp(ndl_material_json(again), ndl_material_json(m)) == 0);
    require(ndl_material_lobes(again) == ndl_material_lobes(m));
    ndl_rgb a = ndl_brdf(m, wi, wo), b = ndl_brdf(again, wi, wo);
    require(memcmp(&a, &b, sizeof a) == 0);
    require(a.r >= 0.0f && a.g >= 0.0f && a.b >= 0.0f);
    ndl_material_free(again);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    char *text = malloc(size + 1);
    if (!text) return 0;
    memcpy(text, data, size);
    text[size] = '\0';
    ndl_error error = {0};
    ndl_material *m = ndl_material_parse(text, &error);
    if (m)
        check_round_trip(m);
    else
        check_error(&error, strlen(text));
    ndl_material_free(m);
    free(text);
    return 0;
}
