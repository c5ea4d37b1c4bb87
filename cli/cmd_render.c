/* SPDX-License-Identifier: Apache-2.0 */
#include "material.h"
#include "options.h"
#include "report.h"

#include "base/error.h"
#include "base/process.h"
#include "base/threads.h"
#include "ndotl/render.h"
#include "render/call.h"
#include "render/tonemap.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_SIDE = 32768, MOST_SAMPLES = 65536 };

static const char shown[] = "wi wo normal tangent position uv albedo D G V F";
static const ndl_show show_of[] = {
    NDL_SHOW_WI,     NDL_SHOW_WO, NDL_SHOW_NORMAL, NDL_SHOW_TANGENT, NDL_SHOW_POSITION, NDL_SHOW_UV,
    NDL_SHOW_ALBEDO, NDL_SHOW_D,  NDL_SHOW_G,      NDL_SHOW_V,       NDL_SHOW_F};

static const cli_option options[] = {
    {"--mesh", "NAME|FILE", NULL, false,
     "sphere (default), shaderball, plane, disc, or a mesh file of any format that assimp reads"},
    {"--material", "NAME=EXPR", NULL, true,
     "material of the parts whose mesh, node or material has that name"},
    {"--light", "EXPR", NULL, true,
     "directional(direction=[x,y,z], irradiance=rgb), direction from the surface to the light, or "
     "point(position=[x,y,z], intensity=rgb, decay=inverse_square|none); default: a key and a fill "
     "light"},
    {"--camera", "EXPR", NULL, false,
     "perspective(eye=[x,y,z], target=[x,y,z], up=[x,y,z], fov_y_deg=35) or parallel(eye, target, "
     "up, height); what is left out looks along -z and frames the mesh"},
    {"--size", "WxH", NULL, false, "pixels (default 512x512)"},
    {"--spp", "N", NULL, false, "samples a pixel (default 1, through its centre)"},
    {"--seed", "N", NULL, false, "of the places of the samples (default 0)"},
    {"--threads", "N", NULL, false, "default: as many as processors; never changes a pixel"},
    {"--integrator", "direct", NULL, false, "direct: the sum over the lights of L * brdf_cos"},
    {"--shadows", NULL, NULL, false, "the mesh shadows itself"},
    {"--tonemap", "EXPR", NULL, false,
     "PNG: clamp (default), reinhard, reinhard_extended(white=4), exponential(k=1) or aces"},
    {"--exposure", "EV", NULL, false, "PNG: times 2^EV before the tone map (default 0)"},
    {"--convention", "NAME", "radiometric scanline", false,
     "scanline: the lecture's quantity in place of brdf_cos, its sum over the lights clamped in "
     "PNG (default radiometric)"},
    {"--show", "WHAT", shown, false,
     "a quantity in place of the light: wi, wo in the local frame, normal, tangent, position in "
     "the world, uv, albedo, or a term; as it is in EXR, scaled in PNG"},
    {"--background", "EXPR", NULL, false, "a colour: a number, [r,g,b] or #rrggbb (default 0)"},
    {"--stats", NULL, NULL, false, "times and counts on stderr"},
    {"-o", "FILE", NULL, false, "the picture: .png (8 bit, sRGB) or .exr (32-bit float, linear)"},
    {NULL, NULL, NULL, false, NULL},
};

/* Everything of one run that is to be released. */
typedef struct {
    const cli_args *args;
    const char *output, *mesh;
    ndl_material **materials; /* the operand's first, then those of --material */
    size_t material_count;
    ndl_scene *scene;
    ndl_image *image;
    ndl_render_desc desc;
    ndl_write_desc write;
    double import_seconds, write_seconds;
    ndl_render_stats stats;
    int bar; /* percent on the terminal; -1: no terminal */
} job;

static int fail_at(const char *path, const ndl_error *error) {
    char quoted[1024];
    nd_quote(path, strlen(path), quoted, sizeof quoted);
    return cli_error("render", CLI_FAILED, quoted, "%s", error->text);
}

static int expression_error(const char *option, const ndl_error *error) {
    if (error->code == NDL_E_CANCELLED) return cli_error("render", CLI_FAILED, NULL, "interrupted");
    return cli_expression_error("render", option, error);
}

/* ---- the command line ------------------------------------------------------------------------ */

static int read_output(job *j) {
    j->output = cli_value(j->args, "-o");
    if (!j->output) return cli_error("render", CLI_USAGE, "-o", "missing; give -o FILE.png");
    size_t n = strlen(j->output);
    if (n > 4 && (strcmp(j->output + n - 4, ".png") == 0 || strcmp(j->output + n - 4, ".exr") == 0))
        return CLI_OK;
    return cli_error("render", CLI_USAGE, "-o", "'%s' ends in neither .png nor .exr",
                     cli_quote(j->output).s);
}

static int read_integrator(const job *j) {
    const char *word = cli_value(j->args, "--integrator");
    if (!word || strcmp(word, "direct") == 0) return CLI_OK;
    if (strcmp(word, "path") == 0)
        return cli_error("render", CLI_USAGE, "--integrator",
                         "this version has no path tracing; use 'direct'");
    return cli_error("render", CLI_USAGE, "--integrator", "unknown word '%s'; use 'direct'",
                     cli_quote(word).s);
}

static int read_numbers(job *j, int *width, int *height) {
    long long samples = 1, threads = 0, seed = 0;
    double exposure = 0.0;
    const cli_args *args = j->args;
    int code = cli_size(args, "--size", LONGEST_SIDE, width, height);
    if (!code) code = cli_integer(args, "--spp", 1, MOST_SAMPLES, &samples);
    if (!code) code = cli_integer(args, "--threads", 1, ND_MOST_THREADS, &threads);
    if (!code) code = cli_integer(args, "--seed", 0, 9007199254740991, &seed);
    if (!code) code = cli_number(args, "--exposure", -100.0, 100.0, &exposure);
    j->desc.samples = (int)samples;
    j->desc.threads = (int)threads;
    j->desc.seed = (unsigned long long)seed;
    j->write.exposure = (float)exposure;
    return code;
}

static int read_words(job *j) {
    const cli_args *args = j->args;
    const char *convention = cli_value(args, "--convention"), *show = cli_value(args, "--show");
    const char *background = cli_value(args, "--background");
    ndl_error error = {0};
    nd_tonemap unused;
    j->desc.shadows = cli_has(args, "--shadows");
    j->desc.scanline = convention && strcmp(convention, "scanline") == 0;
    j->write.scanline = j->desc.scanline;
    if (show) j->desc.show = j->write.show = show_of[nd_word_index(shown, show)];
    j->write.tonemap = cli_value(args, "--tonemap");
    if (j->write.tonemap && !nd_tonemap_parse(j->write.tonemap, &unused, &error))
        return expression_error("--tonemap", &error);
    if (background && !nd_color_parse(background, &j->desc.background, &error))
        return expression_error("--background", &error);
    j->mesh = cli_value(args, "--mesh");
    if (!j->mesh) j->mesh = "sphere";
    return CLI_OK;
}

/* The materials of the command line, before any file is read. */
static int read_materials(job *j) {
    const char *named;
    j->materials = calloc(j->args->given_count + 2, sizeof *j->materials);
    if (!j->materials) return cli_error("render", CLI_FAILED, NULL, "out of memory");
    if (j->args->operand_count) {
        int code = cli_material("render", NULL, j->args->operands[0], &j->materials[0]);
        if (code) return code;
    }
    j->material_count = 1;
    for (size_t i = 0; (named = cli_nth(j->args, "--material", i)) != NULL; i++) {
        const char *equals = strchr(named, '=');
        if (!equals || equals == named)
            return cli_error("render", CLI_USAGE, "--material",
                             "'%s' is not NAME=EXPR, as in ball=lambert", cli_quote(named).s);
        int code = cli_material("render", "--material", equals + 1, &j->materials[1 + i]);
        if (code) return code;
        j->material_count++;
    }
    return CLI_OK;
}

/* ---- the scene ------------------------------------------------------------------------------- */

static int give_materials(job *j) {
    const char *named;
    ndl_error error = {0};
    if (j->materials[0]) ndl_scene_set_material(j->scene, NULL, j->materials[0], NULL);
    for (size_t i = 0; (named = cli_nth(j->args, "--material", i)) != NULL; i++) {
        size_t n = strcspn(named, "=");
        char *name = malloc(n + 1);
        if (!name) return cli_error("render", CLI_FAILED, NULL, "out of memory");
        memcpy(name, named, n);
        name[n] = '\0';
        int failed = ndl_scene_set_material(j->scene, name, j->materials[1 + i], &error);
        free(name);
        if (failed) return expression_error("--material", &error);
    }
    return CLI_OK;
}

static int build_scene(job *j) {
    ndl_error error = {0};
    const char *text;
    double start = nd_clock();
    j->scene = ndl_scene_load(j->mesh, &error);
    j->import_seconds = nd_clock() - start;
    if (!j->scene) return fail_at(j->mesh, &error);
    int code = give_materials(j);
    if (code) return code;
    for (size_t i = 0; (text = cli_nth(j->args, "--light", i)) != NULL; i++)
        if (ndl_scene_add_light(j->scene, text, &error)) return expression_error("--light", &error);
    text = cli_value(j->args, "--camera");
    if (text && ndl_scene_set_camera(j->scene, text, &error))
        return expression_error("--camera", &error);
    return CLI_OK;
}

/* ---- the picture ----------------------------------------------------------------------------- */

/* A bar on a terminal, redrawn when the percentage changes; wiped at the end. */
static int progress(void *user, double done) {
    enum { WIDTH = 40 };
    job *j = user;
    int percent = (int)(100.0 * done);
    if (percent == j->bar) return 0;
    j->bar = percent;
    char bar[WIDTH + 1];
    for (int i = 0; i < WIDTH; i++) bar[i] = 100 * i < WIDTH * percent ? '=' : ' ';
    bar[WIDTH] = '\0';
    if (done < 1.0) fprintf(stderr, "\r[%s] %3d %%", bar, percent);
    else fprintf(stderr, "\r%*s\r", WIDTH + 8, "");
    fflush(stderr);
    return 0;
}

static const char *place_of(const ndl_error *error) {
    if (error->code == NDL_E_RANGE) return "--camera";
    return error->code == NDL_E_UNSUPPORTED ? "--show" : NULL;
}

static int render(job *j) {
    ndl_error error = {0};
    if (nd_stderr_is_terminal()) {
        j->desc.progress = progress;
        j->desc.user = j;
    }
    if (ndl_render(j->scene, &j->desc, j->image, &j->stats, &error)) {
        if (j->desc.progress && j->bar) fputs("\n", stderr);
        const char *place = place_of(&error);
        return cli_error("render", place ? CLI_USAGE : CLI_FAILED, place, "%s", error.text);
    }
    double start = nd_clock();
    if (ndl_image_write(j->image, j->output, &j->write, &error)) return fail_at(j->output, &error);
    j->write_seconds = nd_clock() - start;
    return CLI_OK;
}

static double share(double part, double whole) {
    return whole > 0.0 ? 100.0 * part / whole : 0.0;
}

static void print_stats(const job *j) {
    const ndl_render_stats *s = &j->stats;
    double whole = j->import_seconds + s->seconds + j->write_seconds;
    double worked = s->trace_seconds + s->shade_seconds;
    fprintf(stderr,
            "import and build %9.3f s %5.1f %%\n"
            "render           %9.3f s %5.1f %%  %d threads; of their time:\n"
            "  trace          %9.3f s %5.1f %%  %llu rays, %llu hits, %llu shadow rays\n"
            "  shade          %9.3f s %5.1f %%  %llu evaluations\n"
            "write            %9.3f s %5.1f %%\n",
            j->import_seconds, share(j->import_seconds, whole), s->seconds,
            share(s->seconds, whole), s->threads, s->trace_seconds,
            share(s->trace_seconds, worked), s->rays, s->hits, s->shadow_rays, s->shade_seconds,
            share(s->shade_seconds, worked), s->shaded, j->write_seconds,
            share(j->write_seconds, whole));
}

static int run_job(job *j) {
    int width = 512, height = 512;
    int code = read_output(j);
    if (!code) code = read_integrator(j);
    if (!code) code = read_numbers(j, &width, &height);
    if (!code) code = read_words(j);
    if (!code) code = read_materials(j);
    if (!code) code = build_scene(j);
    if (code) return code;
    j->image = ndl_image_new(width, height);
    if (!j->image) return cli_error("render", CLI_FAILED, NULL, "out of memory for the picture");
    code = render(j);
    if (!code && cli_has(j->args, "--stats")) print_stats(j);
    return code;
}

static int run(const cli_args *args) {
    job j = {.args = args};
    int code = cli_use_environment("render");
    if (code) return code;
    nd_interrupts_catch();
    code = run_job(&j);
    ndl_image_free(j.image);
    ndl_scene_free(j.scene);
    for (size_t i = 0; i <= j.material_count && j.materials; i++) ndl_material_free(j.materials[i]);
    free(j.materials);
    return code;
}

const cli_command cli_render = {
    .name = "render",
    .summary = "a picture of a material on a sphere, a shader ball or a mesh file",
    .usage = "[MATERIAL] [--mesh sphere|shaderball|plane|disc|FILE]\n"
             "[--material NAME=EXPR]... [--light EXPR]... [--camera EXPR] [--size WxH]\n"
             "[--spp N] [--seed N] [--threads N] [--integrator direct] [--shadows]\n"
             "[--tonemap EXPR] [--exposure EV] [--convention radiometric|scanline]\n"
             "[--show WHAT] [--background EXPR] [--stats] -o out.png|out.exr",
    .details =
        "Each pixel is the sum over the lights of L * brdf_cos, L the irradiance on a surface that "
        "faces the light. The world is right-handed with y up. Without MATERIAL a mesh's own glTF "
        "factors are used (metal_rough), else lambert.\n"
        "Pixels depend on the seed, not on the number of threads. The file is written whole or not "
        "at all; a progress bar is drawn on a terminal only.\n"
        "This version has no environment lights, path tracing or textures.\n",
    .example = "ndotl render 'ggx(preset=gold, roughness=0.3)' --mesh shaderball --spp 16 "
               "-o gold.png\n"
               "ndotl render 'lambert(color=0.8)' --light 'point(position=[2,2,2], intensity=20)' "
               "--show wi -o wi.exr",
    .options = options,
    .least = 0,
    .most = 1,
    .operand = NULL,
    .run = run,
};
