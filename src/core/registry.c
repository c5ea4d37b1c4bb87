/* SPDX-License-Identifier: Apache-2.0 */
#include "core/registry.h"

#include "core/models.h"
#include "core/spellings.h"

#include <string.h>

/* A manual's sections: the macro's word is the heading. */
#define SECTION(heading, text) {#heading, text},

#define K(model, kernel, traits) traits,
#define MODEL(name, NAME)                                                                          \
    ND_DEFINE_SCHEMA(schema_of_##name, #name, NAME##_PARAMS, name##_p)                             \
    static const ndl_manual manual_of_##name[] = {NAME##_MANUAL(SECTION)};                         \
    static const unsigned traits_of_##name[] = {NAME##_KERNELS(K)};
#define COMPOSED(name, NAME, ndf)                                                                  \
    ND_DEFINE_SCHEMA(schema_of_##name, #name, NAME##_PARAMS, microfacet_p)                         \
    static const ndl_manual manual_of_##name[] = {NAME##_MANUAL(SECTION)};
#include "core/models.def"
#undef MODEL
#undef COMPOSED
#undef K

#define K(model, kernel, traits) ND_KERNEL_##kernel,
#define COMPOSED(name, NAME, ndf)
#define MODEL(name, NAME) static const int kernels_of_##name[] = {NAME##_KERNELS(K)};
#include "core/models.def"
#undef MODEL
#undef COMPOSED
#undef K

enum { ND_NDF_IS_ANY = ND_ANY_NDF };

#define COUNT(list) (sizeof(list) / sizeof *(list))
static const nd_model MODELS[] = {
#define MODEL(name, NAME)                                                                          \
    {#name,          schema_of_##name, manual_of_##name, COUNT(manual_of_##name),                  \
     traits_of_##name, kernels_of_##name, ND_NO_FACET},
#define COMPOSED(name, NAME, ndf)                                                                  \
    {#name, schema_of_##name, manual_of_##name, COUNT(manual_of_##name), NULL, NULL,               \
     ND_NDF_IS_##ndf},
#include "core/models.def"
#undef MODEL
#undef COMPOSED
};

size_t nd_model_count(void) {
    return COUNT(MODELS);
}

const nd_model *nd_model_at(size_t i) {
    return i < COUNT(MODELS) ? &MODELS[i] : NULL;
}

const nd_model *nd_model_find(const char *name) {
    for (size_t i = 0; i < COUNT(MODELS); i++)
        if (strcmp(MODELS[i].name, name) == 0) return &MODELS[i];
    return NULL;
}

size_t ndl_model_count(void) {
    return COUNT(MODELS);
}

const char *ndl_model_name(size_t i) {
    return i < COUNT(MODELS) ? MODELS[i].name : NULL;
}

int ndl_model_find(const char *name) {
    const nd_model *m = name ? nd_model_find(name) : NULL;
    return m ? (int)(m - MODELS) : -1;
}

const ndl_param *ndl_model_params(size_t i, size_t *count) {
    const nd_schema *s = i < COUNT(MODELS) ? MODELS[i].schema() : NULL;
    if (count) *count = s ? s->count : 0;
    return s ? s->params : NULL;
}

const ndl_manual *ndl_model_manual(size_t i, size_t *count) {
    if (count) *count = i < COUNT(MODELS) ? MODELS[i].manual_count : 0;
    return i < COUNT(MODELS) ? MODELS[i].manual : NULL;
}

/* ---- named substances ------------------------------------------------------------------------ */

#define ETA(r, g, b) {r, g, b}
#define K(r, g, b) {r, g, b}
#define PRESET_METAL(name, eta, k, file, source) {#name, file, source, 1, eta, k},
#define PRESET_DIELECTRIC(name, ior, source) {#name, "", source, 0, {ior, ior, ior}, {0, 0, 0}},
static const ndl_preset PRESETS[] = {
#include "core/presets.def"
};

size_t ndl_preset_count(void) {
    return COUNT(PRESETS);
}

const ndl_preset *ndl_preset_at(size_t i) {
    return i < COUNT(PRESETS) ? &PRESETS[i] : NULL;
}
