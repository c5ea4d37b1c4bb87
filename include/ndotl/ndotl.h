/* SPDX-License-Identifier: Apache-2.0 */
/* ndotl: reflectance models with numbers that can be trusted.

   CONVENTIONS, the same in every function, flag, column and plot
   - Local frame: n = (0,0,1), t = (1,0,0), b = (0,1,0). `wi` points to the light, `wo` to the
     viewer; both are unit vectors that leave the surface. h = normalize(wi + wo).
   - `brdf` is f_r in 1/sr WITHOUT the cosine; `brdf_cos` is f_r * wi.z, computed directly.
   - Lit gate: where wi.z <= 0 or wo.z <= 0 the value is exactly 0, for every model. A value is
     never NaN and never negative; what overflows is FLT_MAX.
   - `alpha` is the microfacet width, `roughness` is perceptual, alpha = roughness^2. An alpha below
     1e-3 acts as 1e-3.
   - Angles are radians; a `_deg` suffix says degrees. Colours are linear Rec.709.

   OWNERSHIP AND THREADS
   A material never changes once made, so any number of threads may use it at once. What an
   ndl_material_... function returns as `ndl_material *` belongs to the caller. Text and table
   pointers of a material or of the registry live as long as the material or the library.
   The library keeps no other state, prints nothing and never exits.

   DOES NOT: transmission, subsurface scattering, spectral rendering. */
#ifndef NDOTL_NDOTL_H
#define NDOTL_NDOTL_H

#include <stddef.h>

#if defined(NDOTL_BUILD) && defined(__GNUC__)
#define NDL_API __attribute__((visibility("default")))
#else
#define NDL_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define NDL_VERSION_MAJOR 0
#define NDL_VERSION_MINOR 1
#define NDL_VERSION_PATCH 0

typedef struct { float x, y, z; } ndl_vec3;
typedef struct { float r, g, b; } ndl_rgb;

/* Status codes are 0 for success, else NDL_E_... ; ndl_status_text() says each in words. */
enum ndl_status {
    NDL_OK = 0,
#define NDL_ERROR(code, text) NDL_E_##code,
#include "ndotl/errors.def"
#undef NDL_ERROR
    NDL_STATUS_COUNT
};

/* What went wrong and where. `column` counts from 1 in the text that was parsed, 0 where no text
   is involved. `text` says what is wrong and what to do, without the place. */
typedef struct { int code, column; char text[256]; } ndl_error; /* code 0: no error */

/* SoA batches: n values behind each pointer, any alignment. */
typedef struct { const float *x, *y, *z; } ndl_vec3_n;
typedef struct { float *x, *y, *z; } ndl_vec3_out;
typedef struct { float *r, *g, *b; } ndl_rgb_n;

/* A material: a weighted sum of lobes of registered models. */
typedef struct ndl_material ndl_material;

/* The library's version, as in "0.1.0". */
NDL_API const char *ndl_version(void);

/* One sentence for a status code; "unknown status" for a number that is none. */
NDL_API const char *ndl_status_text(int code);

/* ---- materials -------------------------------------------------------------------------------

   A material is written as text: "ggx(preset=gold, roughness=0.3)",
   "0.3*lambert(color=0.8) + 0.7*beckmann(alpha=0.2)". The manual of a model
   (`ndotl models NAME`, ndl_model_manual) lists its keys, ranges and defaults.
   Numbers are decimal and correctly rounded to float, whatever the locale. */

/* Makes a material from text.
   Errors:   NULL, and *err says why: NDL_E_SYNTAX, NDL_E_UNKNOWN_NAME, NDL_E_DUPLICATE,
             NDL_E_CONFLICT, NDL_E_RANGE, NDL_E_TYPE (with the column of the offending token),
             NDL_E_MEMORY. `err` may be NULL. */
NDL_API ndl_material *ndl_material_parse(const char *text, ndl_error *err);

/* A copy of m in which `key` of its first lobe has another value; "1.roughness" names the second
   lobe's. The new value takes the place of every other spelling of the same quantity: setting
   roughness drops alpha. m is untouched.
   Domain:   a number key of the model, value in the key's range. For a colour key all channels
             are set, "color.g" sets one.
   Errors:   NULL with NDL_E_UNKNOWN_NAME, NDL_E_RANGE, NDL_E_TYPE, NDL_E_CONFLICT, NDL_E_MEMORY. */
NDL_API ndl_material *ndl_material_with(const ndl_material *m, const char *key, double value,
                                        ndl_error *err);

/* Releases a material; NULL is allowed. */
NDL_API void ndl_material_free(ndl_material *m);

/* The material in canonical short form; parsing it gives a material with the same bits. */
NDL_API const char *ndl_material_text(const ndl_material *m);

/* The material in the JSON long form: {"lobes":[{"weight":[r,g,b],"model":...,"params":{...}}]}. */
NDL_API const char *ndl_material_json(const ndl_material *m);

/* Number of lobes, 1 or more. */
NDL_API size_t ndl_material_lobes(const ndl_material *m);

/* The model name of lobe i < ndl_material_lobes(m). */
NDL_API const char *ndl_material_model(const ndl_material *m, size_t i);

/* ---- values ---------------------------------------------------------------------------------- */

/* The BRDF f_r(wi, wo), 1/sr, without the cosine.
   Domain:   unit vectors in the local frame; 0 unless wi.z > 0 and wo.z > 0.
   Accuracy: per lobe |got - exact| <= (16 + 4k) 2^-23 |exact| + 1e-37, k the condition number with
             respect to directions and parameters (tests/golden). */
NDL_API ndl_rgb ndl_brdf(const ndl_material *m, ndl_vec3 wi, ndl_vec3 wo);

/* f_r(wi, wo) * wi.z, 1/sr, computed directly; domain and accuracy as ndl_brdf. */
NDL_API ndl_rgb ndl_brdf_cos(const ndl_material *m, ndl_vec3 wi, ndl_vec3 wo);

/* The same for n pairs of directions. An output array may be one of the input arrays (the same
   pointer, not shifted). Bit for bit what n scalar calls give. */
NDL_API void ndl_brdf_n(const ndl_material *m, size_t n, ndl_vec3_n wi, ndl_vec3_n wo,
                        ndl_rgb_n rgb);
NDL_API void ndl_brdf_cos_n(const ndl_material *m, size_t n, ndl_vec3_n wi, ndl_vec3_n wo,
                            ndl_rgb_n rgb);

/* One parameter per lane: `key` as ndl_material_with() takes it ("roughness", "color.r",
   "1.alpha_x"), values: one for each of the n pairs. */
typedef struct { const char *key; const float *values; } ndl_lanes;

/* ndl_brdf_n and ndl_brdf_cos_n with parameters that differ from pair to pair, as from textures.
   Pair i has the value of ndl_material_with(m, key, values[i]) for all lanes, but which formulas
   are used (variant, ndf, masking, fresnel, roughness_map ...) is m's: `ior` needs a dielectric m,
   `k` a conductor, `f0` one of the others.
   Domain:   values outside the key's range act as the nearest end of it, NaN as its low end.
   Errors:   a key that ndl_lanes_check() refuses makes every value 0. */
NDL_API void ndl_brdf_lanes_n(const ndl_material *m, size_t lanes, const ndl_lanes *lane, size_t n,
                              ndl_vec3_n wi, ndl_vec3_n wo, ndl_rgb_n rgb);
NDL_API void ndl_brdf_cos_lanes_n(const ndl_material *m, size_t lanes, const ndl_lanes *lane,
                                  size_t n, ndl_vec3_n wi, ndl_vec3_n wo, ndl_rgb_n rgb);

/* Whether the lanes can be used with m: NDL_OK, or NDL_E_UNKNOWN_NAME (no such number in m),
   NDL_E_CONFLICT (two lanes give the same quantity, or m's formulas do not use it) with *err. */
NDL_API int ndl_lanes_check(const ndl_material *m, size_t lanes, const ndl_lanes *lane,
                            ndl_error *err);

/* ndl_brdf_n and ndl_brdf_cos_n by several threads, for large batches: the same bits whatever their
   number. `threads` counts the caller's; 0 or less means all processors. They are started and ended
   within the call, so fewer than NDL_THREADS_LEAST pairs are left to the caller's thread alone, and
   a machine that gives no more threads is no error. */
enum { NDL_THREADS_LEAST = 65536 };
NDL_API void ndl_brdf_threads_n(const ndl_material *m, int threads, size_t n, ndl_vec3_n wi,
                                ndl_vec3_n wo, ndl_rgb_n rgb);
NDL_API void ndl_brdf_cos_threads_n(const ndl_material *m, int threads, size_t n, ndl_vec3_n wi,
                                    ndl_vec3_n wo, ndl_rgb_n rgb);

/* The lecture's scan-line quantity [Gribaudo24]: cosine inside, no 1/pi on the diffuse part.
   pi * brdf_cos for lambert and oren_nayar lobes, brdf_cos for all others. Never clamped. */
NDL_API ndl_rgb ndl_scanline(const ndl_material *m, ndl_vec3 wi, ndl_vec3 wo);
NDL_API void ndl_scanline_n(const ndl_material *m, size_t n, ndl_vec3_n wi, ndl_vec3_n wo,
                            ndl_rgb_n rgb);

/* The factors of a microfacet BRDF f_r = F * D * V. */
typedef enum {
    NDL_TERM_D, /* normal distribution, 1/sr */
    NDL_TERM_G, /* masking-shadowing, 1, in [0, 1] */
    NDL_TERM_V, /* G / (4 NoL NoV), 1 */
    NDL_TERM_F  /* Fresnel reflectance, 1, per channel */
} ndl_term_kind;

/* Whether the material is one lobe of a model with that factor. */
NDL_API int ndl_has_term(const ndl_material *m, ndl_term_kind term);

/* One factor at (wi, wo); D, G and V stand in all three channels. 0 outside the lit gate and for a
   material without that factor. */
NDL_API ndl_rgb ndl_term(const ndl_material *m, ndl_term_kind term, ndl_vec3 wi, ndl_vec3 wo);
NDL_API void ndl_term_n(const ndl_material *m, ndl_term_kind term, size_t n, ndl_vec3_n wi,
                        ndl_vec3_n wo, ndl_rgb_n rgb);

/* The directional albedo E(wo): the integral of f_r(wi, wo) wi.z over all wi, per channel, by
   adaptive quadrature in wi around the reflection of wo.
   Domain:   wo.z > 0, else 0. tolerance: absolute, per channel; 0 means 1e-5.
   Errors:   *error, when not NULL, is the estimated absolute error of the worst channel; larger
             than tolerance when the work limit stopped the refinement. */
NDL_API ndl_rgb ndl_albedo(const ndl_material *m, ndl_vec3 wo, float tolerance, float *error);

/* The mirror direction of w at a surface with unit normal n: 2 (n.w) n - w. Like w it leaves the
   surface, so for w towards the light this is the lecture's r and, in GLSL, -reflect(w, n) or
   reflect(-w, n); with w from the light to the surface r would point into the surface.
   Domain:   any frame; |n| = 1. |w| is kept. w below the surface gives a mirror below it.
   Accuracy: computed in double, each component rounded once.
   Source:   [Phong75]; formulas S4.19, S4.20. The order that S4's text gives (S4.18) is
             3 w - 2 (n.w) n. */
NDL_API ndl_vec3 ndl_reflect(ndl_vec3 w, ndl_vec3 n);

/* ---- drawing directions -------------------------------------------------------------------------

   Importance sampling of brdf_cos: each model draws by its own density, which its manual gives
   (`ndotl models NAME`, section sampling). A sum is a mixture: u.z chooses a lobe, with chances
   that follow the lobes' albedos, and the density is that of the whole mixture. */

/* One drawn direction. pdf 0: no sample; the weight is 0 then, and wi is not to be used. */
typedef struct { ndl_vec3 wi; ndl_rgb weight; float pdf; } ndl_sample;

/* Draws wi for a viewer at wo. weight = f_r(wi, wo) wi.z / pdf, 1, so that its mean over u is the
   directional albedo; pdf: density of wi, 1/sr, what ndl_pdf(m, wi, wo) returns, bit for bit.
   Domain:   u: three numbers in [0, 1), the float below 1 included. wo.z <= 0: all is 0.
             A direction that falls below the horizon is no sample. wi is a unit vector to 1e-6. */
NDL_API ndl_sample ndl_draw(const ndl_material *m, ndl_vec3 wo, ndl_vec3 u);

/* The density, 1/sr, with which ndl_draw draws wi for wo; 0 unless wi.z > 0 and wo.z > 0. Over all
   wi it adds up to 1 less the share of draws that give no sample.
   Accuracy: as ndl_brdf. */
NDL_API float ndl_pdf(const ndl_material *m, ndl_vec3 wi, ndl_vec3 wo);

/* f_r(wi, wo) wi.z and the density, at once, as multiple importance sampling needs them. */
NDL_API ndl_rgb ndl_brdf_cos_pdf(const ndl_material *m, ndl_vec3 wi, ndl_vec3 wo, float *pdf);

/* The same for n directions; bit for bit what n scalar calls give. No output may overlap an input,
   but pdf of ndl_pdf_n may be one of the inputs' arrays. */
NDL_API void ndl_draw_n(const ndl_material *m, size_t n, ndl_vec3_n wo, ndl_vec3_n u,
                        ndl_vec3_out wi, ndl_rgb_n weight, float *pdf);
NDL_API void ndl_pdf_n(const ndl_material *m, size_t n, ndl_vec3_n wi, ndl_vec3_n wo, float *pdf);
NDL_API void ndl_brdf_cos_pdf_n(const ndl_material *m, size_t n, ndl_vec3_n wi, ndl_vec3_n wo,
                                ndl_rgb_n rgb, float *pdf);

/* ---- registry -------------------------------------------------------------------------------- */

typedef enum {
    NDL_KIND_NUMBER, /* one float */
    NDL_KIND_COLOR,  /* linear Rec.709, three floats */
    NDL_KIND_CHOICE, /* one word of `words` */
    NDL_KIND_RAMP,   /* [x: color, x: color, ...] */
    NDL_KIND_WORD,   /* a name, such as a preset's */
    NDL_KIND_VECTOR  /* three numbers (lights and cameras) */
} ndl_kind;

/* One key of a model. */
typedef struct {
    const char *key, *unit, *feel; /* feel: what its values look like */
    ndl_kind kind;
    int above_low;       /* the lower bound itself is excluded */
    int is_spelling;     /* another way to give the quantity `group`, such as roughness for alpha */
    const char *group;   /* quantity that several keys spell, or NULL */
    double low, high;    /* range of a number, of each channel, of a vector's components */
    double initial[3];   /* default; NaN where the key has none (spellings) */
    const char *words;   /* of a choice: its words separated by blanks; else NULL */
    const char *initial_word;
} ndl_param;

/* One section of a manual: heading ("WHAT", "FORMULA", "LIMITS", ..., or a choice of the model,
   "masking=smith") and prose. */
typedef struct { const char *heading, *text; } ndl_manual;

/* Laws that a model claims to obey, besides being finite, non-negative and gated. */
enum {
    NDL_CLAIM_RECIPROCITY = 1, /* f_r(wi, wo) = f_r(wo, wi) */
    NDL_CLAIM_ENERGY = 2,      /* directional albedo <= 1 */
    NDL_CLAIM_CONTINUITY = 4   /* brdf_cos has no jump */
};

/* The registered models, i < ndl_model_count(); beyond it NULL. Everything that these functions
   return is constant and lives as long as the library. */
NDL_API size_t ndl_model_count(void);
NDL_API const char *ndl_model_name(size_t i);
/* Index of a model, or -1. */
NDL_API int ndl_model_find(const char *name);
/* Keys of model i: *count of them, in printing order. */
NDL_API const ndl_param *ndl_model_params(size_t i, size_t *count);
/* Sections of model i's manual, *count of them, in reading order. */
NDL_API const ndl_manual *ndl_model_manual(size_t i, size_t *count);
/* The laws that a material claims, NDL_CLAIM_...: those that all of its lobes claim, energy only
   where the weights add up to 1 at most in every channel. */
NDL_API unsigned ndl_material_claims(const ndl_material *m);

/* A named substance. Metals give eta and k, dielectrics ior (eta[0..2] equal, k 0). */
typedef struct {
    const char *name, *file, *source;
    int is_metal;
    float eta[3], k[3];
} ndl_preset;
/* The named substances, i < ndl_preset_count(); beyond it NULL. */
NDL_API size_t ndl_preset_count(void);
NDL_API const ndl_preset *ndl_preset_at(size_t i);

/* ---- instruction sets ------------------------------------------------------------------------ */

/* The kernels in use: "scalar", "x86-64", "x86-64-v3", "x86-64-v4" or "neon". */
NDL_API const char *ndl_isa(void);
/* Kernels of another instruction set from now on, in this process; NULL or "" means the best.
   Errors:   NDL_E_UNKNOWN_NAME: none of that name, or this machine lacks it; nothing changes. */
NDL_API int ndl_use_isa(const char *name);

#ifdef __cplusplus
}
#endif
#endif
