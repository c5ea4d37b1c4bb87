/* SPDX-License-Identifier: Apache-2.0 */
/* ndotl: pictures of materials. Link with libndotl-workbench.

       ndl_error err;
       ndl_material *gold = ndl_material_parse("ggx(preset=gold, roughness=0.3)", &err);
       ndl_scene *scene = ndl_scene_load("shaderball", &err);
       ndl_scene_set_material(scene, NULL, gold, &err);
       ndl_image *image = ndl_image_new(640, 480);
       ndl_render(scene, &(ndl_render_desc){.samples = 16}, image, NULL, &err);
       ndl_image_write(image, "gold.png", &(ndl_write_desc){0}, &err);

   CONVENTIONS
   - World: right-handed, y up. Local frame at a point: n the shading normal, turned to the viewer;
     t along the texture coordinate u, perpendicular to n; b = n x t.
   - The picture is the sum over the lights of L * brdf_cos, L the irradiance on a surface that
     faces the light: no hidden pi. No interreflection; shadows on request.
   - Pixel (0, 0) is top left, its centre at (0.5, 0.5). Box filter. One sample goes through the
     centre of the pixel; more are spread over it, as the seed says.
   - Pixels depend on the description alone, not on the number of threads.

   OWNERSHIP AND THREADS
   A scene belongs to one thread while it is changed; ndl_render only reads it. Functions that
   return int give NDL_OK, or a status code with *err filled; `err` may be NULL everywhere.

   DOES NOT: environment lights, path tracing, textures, transparency. */
#ifndef NDOTL_RENDER_H
#define NDOTL_RENDER_H

#include "ndotl/ndotl.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- scenes ---------------------------------------------------------------------------------- */

/* A mesh with materials, lights and a camera. */
typedef struct ndl_scene ndl_scene;

/* Loads a built-in mesh (a name of ndl_scene_builtins) or a mesh file of any format that assimp
   reads. Files are imported in a child process with limits of memory and time; node transforms are
   applied, nothing else is changed. Until they are set: the materials are the file's glTF
   metallic-roughness factors (metal_rough, without textures), else lambert; the lights a fixed key
   and fill light; the camera looks along -z at the whole of it.
   Errors:   NULL with NDL_E_FILE (missing, malformed, no triangle that has an area), NDL_E_LIMIT,
             NDL_E_MEMORY, NDL_E_CANCELLED. The text does not repeat the name. */
NDL_API ndl_scene *ndl_scene_load(const char *mesh, ndl_error *err);

/* Releases a scene; NULL is allowed. */
NDL_API void ndl_scene_free(ndl_scene *scene);

/* The names of the built-in meshes, separated by blanks. */
NDL_API const char *ndl_scene_builtins(void);

/* Number of parts: the pieces of a mesh that can have different materials. */
NDL_API size_t ndl_scene_parts(const ndl_scene *scene);

/* The names of part i < ndl_scene_parts(scene), "" where it has none. */
typedef struct { const char *mesh, *node, *material; } ndl_part_names;
NDL_API ndl_part_names ndl_scene_part(const ndl_scene *scene, size_t i);

/* Gives `m` to every part whose mesh, node or material has that name, or to all with NULL. The
   scene refers to m, which must live as long as the scene is rendered with it.
   Errors:   NDL_E_UNKNOWN_NAME: no part of that name; the text lists them. */
NDL_API int ndl_scene_set_material(ndl_scene *scene, const char *name, const ndl_material *m,
                                   ndl_error *err);

/* Adds a light; the first one replaces the fixed key and fill light.
       directional(direction=[x, y, z], irradiance=rgb)    from the surface to the light
       point(position=[x, y, z], intensity=rgb, decay=inverse_square|none)
   Errors:   those of expressions, with the column; NDL_E_MEMORY. */
NDL_API int ndl_scene_add_light(ndl_scene *scene, const char *text, ndl_error *err);

/* Sets the camera.
       perspective(eye, target, up=[0, 1, 0], fov_y_deg=35)
       parallel(eye, target, up, height)
   What is left out frames the bounding sphere. Errors: those of expressions, with the column. */
NDL_API int ndl_scene_set_camera(ndl_scene *scene, const char *text, ndl_error *err);

/* ---- pictures -------------------------------------------------------------------------------- */

/* Linear Rec.709, three floats a pixel, rows from the top. */
typedef struct {
    int width, height;
    float *rgb;
} ndl_image;

/* A black picture, each side 1 to 32768; NULL when memory is out. Release with ndl_image_free. */
NDL_API ndl_image *ndl_image_new(int width, int height);
NDL_API void ndl_image_free(ndl_image *image);

/* What the pixels are. Directions wi, wo are in the local frame, the others in the world's; 0
   where the ray meets nothing. wi is of the first light. D, G, V need one material that has them
   everywhere (ndl_has_term). */
typedef enum {
    NDL_SHOW_RADIANCE,
    NDL_SHOW_WI, NDL_SHOW_WO, NDL_SHOW_NORMAL, NDL_SHOW_TANGENT, NDL_SHOW_POSITION, NDL_SHOW_UV,
    NDL_SHOW_ALBEDO, /* directional albedo at wo, to 1e-4 */
    NDL_SHOW_D, NDL_SHOW_G, NDL_SHOW_V, NDL_SHOW_F
} ndl_show;

/* Zero means the default. */
typedef struct {
    int samples;             /* a pixel; 1 */
    int threads;             /* as many as there are processors */
    unsigned long long seed; /* of the samples' places */
    int shadows;             /* whether the mesh shadows itself */
    int scanline;            /* ndl_scanline in place of brdf_cos: the lecture's convention */
    ndl_show show;
    ndl_rgb background;      /* radiance where the ray meets nothing */
    int (*progress)(void *user, double done); /* done in (0, 1]; not 0 stops; one call at a time,
                                                 from any thread */
    void *user;
} ndl_render_desc;

/* What a picture took. Times of tracing and shading are summed over the threads. */
typedef struct {
    double seconds, trace_seconds, shade_seconds;
    unsigned long long rays, hits, shadow_rays, shaded; /* shaded: pairs of directions evaluated */
    int threads;
} ndl_render_stats;

/* Renders into the picture. `stats` may be NULL.
   Errors:   NDL_E_RANGE (camera: eye and target are one, up along the view; samples beyond 65536),
             NDL_E_UNSUPPORTED (show: the material lacks the term), NDL_E_CANCELLED, NDL_E_MEMORY;
             the picture is then of no use. */
NDL_API int ndl_render(const ndl_scene *scene, const ndl_render_desc *desc, ndl_image *image,
                       ndl_render_stats *stats, ndl_error *err);

/* How a picture becomes a file; zero means the default. */
typedef struct {
    const char *tonemap; /* PNG: "clamp"; reinhard, reinhard_extended(white=4), exponential(k=1),
                            aces */
    float exposure;      /* PNG: times 2^exposure before the tone map */
    int scanline;        /* PNG: cut to [0, 1] before the exposure, as the lecture does */
    ndl_show show;       /* PNG: directions become 0.5 + 0.5 x, positions fill [0, 1] from the least
                            to the largest of each channel, D and V are divided by the largest
                            value, the others are cut to [0, 1]; without tone map and encoding */
} ndl_write_desc;

/* Writes a .png (8 bit, sRGB) or .exr (32-bit float, linear) file, whole or not at all. In PNG,
   exposure, then the tone map per channel, then the sRGB encoding, rounded to nearest.
   Errors:   NDL_E_UNKNOWN_NAME: another extension, or an unknown tone map (with column);
             NDL_E_FILE: cannot be written; NDL_E_MEMORY. */
NDL_API int ndl_image_write(const ndl_image *image, const char *path, const ndl_write_desc *desc,
                            ndl_error *err);

#ifdef __cplusplus
}
#endif
#endif
