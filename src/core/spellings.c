/* SPDX-License-Identifier: Apache-2.0 */
#include "core/spellings.h"

#include "base/error.h"
#include "base/nearest.h"
#include "core/models.h"
#include "shade/convert.h"

#include <string.h>

/* ---- widths ---------------------------------------------------------------------------------- */

static const char TWO_WIDTHS[] = "both give the width; keep one";

/* A key that does not belong here is at fault itself, a number out of range is where it stands. */
static bool fail_at(nd_binding *b, const char *key, int code, const char *why) {
    const nd_arg *arg = nd_given(b, key);
    int column = code == NDL_E_RANGE ? arg->value.column : arg->column;
    return nd_fail(b->error, code, column, "'", arg->key, "' ", why, NULL);
}

/* A width that a conversion has taken out of range acts as the range's end. */
static float width_in_range(float alpha, float largest) {
    float floor = ALPHA_FLOOR;
    return alpha < floor ? floor : alpha > largest ? largest : alpha;
}

static float mapped_alpha(const nd_binding *b) {
    float roughness = nd_number(b, "roughness");
    switch (nd_choice(b, "roughness_map")) {
    case 1: return alpha_from_roughness_direct(roughness);
    case 2: return alpha_from_roughness_sqrt(roughness);
    default: return alpha_from_roughness(roughness);
    }
}

static widths stretched(int kind, float alpha, float anisotropy) {
    switch (kind) {
    case 1: return widths_kulla(alpha, anisotropy);
    case 2: return widths_openpbr(alpha, anisotropy);
    case 3: return widths_gltf(alpha, anisotropy);
    default: return widths_burley(alpha, anisotropy);
    }
}

void nd_width_lanes(size_t n, const float *values, int map, int kind, const float *anisotropy,
                    bool anisotropy_per_lane, float largest, float *x, float *y) {
    for (size_t i = 0; i < n; i++) x[i] = values[i];
    if (map == 0)
        for (size_t i = 0; i < n; i++) x[i] = alpha_from_roughness(x[i]);
    if (map == 2)
        for (size_t i = 0; i < n; i++) x[i] = alpha_from_roughness_sqrt(x[i]);
    if (!anisotropy_per_lane && anisotropy[0] == 0.0f) {
        for (size_t i = 0; i < n; i++) x[i] = y[i] = width_in_range(x[i], largest);
        return;
    }
    for (size_t i = 0; i < n; i++) {
        widths w = stretched(kind, x[i], anisotropy[anisotropy_per_lane ? i : 0]);
        x[i] = width_in_range(w.x, largest);
        y[i] = width_in_range(w.y, largest);
    }
}

/* The ndf=blinn of microfacet is a power of a cosine: no stretch, exponent >= 0. */
static bool check_blinn(nd_binding *b, widths w) {
    if (nd_choice(b, "ndf") != ND_NDF_IS_blinn) return true;
    if (w.x != w.y) {
        const char *key = nd_given(b, "anisotropy") ? "anisotropy"
                          : nd_given(b, "alpha_x")  ? "alpha_x"
                                                    : "alpha_y";
        return fail_at(b, key, NDL_E_CONFLICT,
                       "stretches the highlight, but ndf=blinn is isotropic; use beckmann or ggx");
    }
    if (w.x > 1.0f)
        return fail_at(b, nd_given(b, "alpha") ? "alpha" : "alpha_x", NDL_E_RANGE,
                       "may be at most 1 with ndf=blinn");
    return true;
}

static bool resolve_width(nd_binding *b) {
    if (!nd_exclusive(b, "alpha", "roughness", TWO_WIDTHS) ||
        !nd_exclusive(b, "alpha", "alpha_x", TWO_WIDTHS) ||
        !nd_exclusive(b, "alpha", "alpha_y", TWO_WIDTHS) ||
        !nd_exclusive(b, "roughness", "alpha_x", TWO_WIDTHS) ||
        !nd_exclusive(b, "roughness", "alpha_y", TWO_WIDTHS) ||
        !nd_exclusive(b, "anisotropy", "alpha_x", "alpha_x and alpha_y say it already") ||
        !nd_exclusive(b, "anisotropy", "alpha_y", "alpha_x and alpha_y say it already"))
        return false;
    bool rough = nd_given(b, "roughness") != NULL;
    if (nd_given(b, "roughness_map") && !rough)
        return fail_at(b, "roughness_map", NDL_E_CONFLICT,
                       "says what roughness means, but no roughness is given; add it");
    widths w = {nd_number(b, "alpha_x"), nd_number(b, "alpha_y")};
    if (!nd_given(b, "alpha_x") && !nd_given(b, "alpha_y")) {
        float alpha = rough ? mapped_alpha(b) : nd_number(b, "alpha");
        w = stretched(nd_choice(b, "anisotropy_kind"), alpha, nd_number(b, "anisotropy"));
    }
    if (!check_blinn(b, w)) return false;
    w.x = width_in_range(w.x, 4.0f);
    w.y = width_in_range(w.y, 4.0f);
    microfacet_p *p = (microfacet_p *)(void *)b->fields;
    p->alpha_x = w.x;
    p->alpha_y = w.y;
    p->direct_roughness = rough ? nd_number(b, "roughness") : roughness_from_alpha(w.x);
    return true;
}
const nd_group nd_group_width = {"width", resolve_width, "alpha_x alpha_y"};

static bool resolve_ward_width(nd_binding *b) {
    if (!nd_exclusive(b, "alpha", "alpha_x", TWO_WIDTHS) ||
        !nd_exclusive(b, "alpha", "alpha_y", TWO_WIDTHS))
        return false;
    ward_p *p = (ward_p *)(void *)b->fields;
    bool both = nd_given(b, "alpha") != NULL;
    p->alpha_x = width_in_range(nd_number(b, both ? "alpha" : "alpha_x"), 4.0f);
    p->alpha_y = width_in_range(nd_number(b, both ? "alpha" : "alpha_y"), 4.0f);
    return true;
}
const nd_group nd_group_ward_width = {"ward_width", resolve_ward_width, "alpha_x alpha_y"};

static bool resolve_metal_width(nd_binding *b) {
    float alpha = alpha_from_roughness(nd_number(b, "roughness"));
    widths w = widths_burley(alpha, nd_number(b, "anisotropy"));
    metal_rough_p *p = (metal_rough_p *)(void *)b->fields;
    p->alpha_x = width_in_range(w.x, 4.0f);
    p->alpha_y = width_in_range(w.y, 4.0f);
    return true;
}
const nd_group nd_group_metal_width = {"metal_width", resolve_metal_width, ""};

/* ---- diffuse --------------------------------------------------------------------------------- */

/* sin sin over the square roots of 1 - cosine: smooth, so that bilinear interpolation is good. */
static bool build_sine_table(nd_binding *b, table2 *t) {
    enum { N = OREN_NAYAR_TABLE_SIZE };
    float *v = nd_arena_alloc(b->arena, N * N * sizeof *v);
    if (!v) return nd_fail(b->error, NDL_E_MEMORY, 0, "out of memory", NULL);
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++)
            v[j * N + i] = oren_nayar_sines((float)i / (N - 1), (float)j / (N - 1));
    *t = (table2){v, N, N};
    return true;
}

static bool resolve_oren_nayar_width(nd_binding *b) {
    if (!nd_exclusive(b, "sigma", "a", "both give the roughness; keep one")) return false;
    oren_nayar_p *p = (oren_nayar_p *)(void *)b->fields;
    if (nd_given(b, "a")) p->sigma = sigma_from_a(nd_number(b, "a"));
    bool table = nd_choice(b, "variant") == nd_word_index(OREN_NAYAR_WORDS, "table");
    return table ? build_sine_table(b, &p->sines) : true;
}
const nd_group nd_group_oren_nayar_width = {"oren_nayar_width", resolve_oren_nayar_width, "sigma"};

static bool resolve_toon(nd_binding *b) {
    static const char why[] = "a ramp holds all colours; keep the ramp or the two colours";
    return nd_exclusive(b, "ramp", "color1", why) && nd_exclusive(b, "ramp", "color2", why) &&
           nd_exclusive(b, "ramp", "threshold", why);
}
const nd_group nd_group_toon = {"toon", resolve_toon, "color1 color2 threshold"};

/* ---- Fresnel --------------------------------------------------------------------------------- */

static bool find_preset(nd_binding *b, const ndl_preset **preset) {
    const nd_arg *arg = nd_given(b, "preset");
    *preset = NULL;
    if (!arg) return true;
    for (size_t i = 0; i < ndl_preset_count(); i++)
        if (strcmp(ndl_preset_at(i)->name, arg->value.word) == 0) *preset = ndl_preset_at(i);
    if (*preset) return true;
    char quoted[48];
    nd_quote(arg->value.word, strlen(arg->value.word), quoted, sizeof quoted);
    nd_nearest near = {arg->value.word, NULL, 0};
    for (size_t i = 0; i < ndl_preset_count(); i++) nd_nearest_offer(&near, ndl_preset_at(i)->name);
    if (near.best)
        return nd_fail(b->error, NDL_E_UNKNOWN_NAME, arg->value.column, "unknown preset '", quoted,
                       "'; did you mean '", near.best, "'?", NULL);
    return nd_fail(b->error, NDL_E_UNKNOWN_NAME, arg->value.column, "unknown preset '", quoted,
                   "'; `ndotl models --presets` lists them", NULL);
}

static bool exclusive_indices(nd_binding *b) {
    static const char *const pairs[][2] = {
        {"preset", "f0"}, {"preset", "ior"}, {"preset", "eta"}, {"preset", "k"}, {"ior", "eta"},
        {"ior", "k"},     {"f0", "ior"},     {"f0", "eta"},     {"f0", "k"},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        if (!nd_exclusive(b, pairs[i][0], pairs[i][1], "both give the reflectance; keep one"))
            return false;
    return true;
}

/* The complex index that was given, in whichever way; false where none was. */
static bool given_index(const nd_binding *b, const ndl_preset *preset, vec3 *eta, vec3 *k) {
    const microfacet_p *p = (const microfacet_p *)(const void *)b->fields;
    *k = v3_splat(0.0f);
    if (preset) {
        *eta = v3(preset->eta[0], preset->eta[1], preset->eta[2]);
        *k = v3(preset->k[0], preset->k[1], preset->k[2]);
    } else if (nd_given(b, "ior")) {
        *eta = v3_splat(p->ior);
    } else if (nd_given(b, "k")) {
        *eta = p->eta;
        *k = p->k;
    } else if (nd_given(b, "eta")) {
        *eta = p->eta;
    }
    return preset || nd_given(b, "ior") || nd_given(b, "k") || nd_given(b, "eta");
}

static bool is_zero(vec3 v) {
    return v.x == 0.0f && v.y == 0.0f && v.z == 0.0f;
}

static bool absorbs(const nd_binding *b, const ndl_preset *preset) {
    return preset ? preset->is_metal != 0 : nd_given(b, "k") != NULL;
}

/* A dielectric whose index differs between the channels is a conductor with k = 0. */
static void choose_kernel(nd_binding *b, vec3 eta) {
    bool grey = eta.x == eta.y && eta.x == eta.z;
    if (nd_choice(b, "fresnel") == ND_FRESNEL_IS_dielectric && !grey)
        nd_choose(b, "fresnel", ND_FRESNEL_IS_conductor);
}

static float f0_of_index(float eta, float k) {
    double e = (double)eta, kk = (double)k * (double)k;
    return (float)(((e - 1.0) * (e - 1.0) + kk) / ((e + 1.0) * (e + 1.0) + kk));
}

static bool resolve_fresnel(nd_binding *b) {
    const ndl_preset *preset;
    vec3 eta, k;
    if (!find_preset(b, &preset) || !exclusive_indices(b)) return false;
    bool index = given_index(b, preset, &eta, &k);
    if (!nd_given(b, "fresnel"))
        nd_choose(b, "fresnel",
                  !index               ? ND_FRESNEL_IS_schlick
                  : absorbs(b, preset) ? ND_FRESNEL_IS_conductor
                                       : ND_FRESNEL_IS_dielectric);
    int fresnel = nd_choice(b, "fresnel");
    bool exact = fresnel == ND_FRESNEL_IS_dielectric || fresnel == ND_FRESNEL_IS_conductor;
    if (exact && nd_given(b, "f0"))
        return fail_at(b, "f0", NDL_E_CONFLICT,
                       "is not used by this fresnel; fresnel=cook_torrance is exact for an f0");
    if (fresnel == ND_FRESNEL_IS_dielectric && index && !is_zero(k))
        return fail_at(b, preset ? "preset" : "k", NDL_E_CONFLICT,
                       "absorbs, which fresnel=dielectric does not; use fresnel=conductor");
    if (!index) return true;
    choose_kernel(b, eta);
    microfacet_p *p = (microfacet_p *)(void *)b->fields;
    p->eta = eta;
    p->k = k;
    p->ior = eta.x;
    if (!exact)
        p->f0 = v3(f0_of_index(eta.x, k.x), f0_of_index(eta.y, k.y), f0_of_index(eta.z, k.z));
    return true;
}
const nd_group nd_group_fresnel = {"fresnel", resolve_fresnel, "f0 ior eta k"};
