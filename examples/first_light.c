/* SPDX-License-Identifier: Apache-2.0 */
/* The shader ball in gold, brushed aluminium and white clay, side by side in one picture.

       cc first_light.c $(pkg-config --cflags --libs ndotl-workbench) -o first_light
       ./first_light first_light.png */
#include <ndotl/ndotl.h>
#include <ndotl/render.h>

#include <stdio.h>
#include <string.h>

enum { COUNT = 3, SIDE = 480 };

static const char *const materials[COUNT] = {
    "ggx(preset=gold, roughness=0.3)",
    "ggx(preset=aluminium, alpha_x=0.1, alpha_y=0.4)", /* brushed around: wide across the grooves */
    "lambert(color=0.8)",
};

/* Renders one material into its third of the picture. */
static int add_ball(ndl_scene *scene, const char *text, int place, ndl_image *all,
                    ndl_error *error) {
    ndl_material *m = ndl_material_parse(text, error);
    ndl_image *one = ndl_image_new(SIDE, SIDE);
    int code = !m ? error->code : !one ? NDL_E_MEMORY : NDL_OK;
    if (!code) code = ndl_scene_set_material(scene, NULL, m, error);
    ndl_render_desc desc = {.samples = 16, .shadows = 1, .background = {0.02f, 0.025f, 0.03f}};
    if (!code) code = ndl_render(scene, &desc, one, NULL, error);
    for (size_t y = 0; !code && y < SIDE; y++)
        memcpy(all->rgb + 3 * SIDE * (COUNT * y + (size_t)place), one->rgb + 3 * SIDE * y,
               3 * SIDE * sizeof(float));
    ndl_image_free(one);
    ndl_material_free(m);
    return code;
}

int main(int argc, char **argv) {
    const char *path = argc > 1 ? argv[1] : "first_light.png";
    ndl_error error = {0};
    ndl_scene *scene = ndl_scene_load("shaderball", &error);
    ndl_image *all = ndl_image_new(COUNT * SIDE, SIDE);
    int code = !scene ? error.code : !all ? NDL_E_MEMORY : NDL_OK;
    for (int i = 0; !code && i < COUNT; i++)
        code = add_ball(scene, materials[i], i, all, &error);
    if (!code) code = ndl_image_write(all, path, &(ndl_write_desc){.tonemap = "aces"}, &error);
    if (code)
        fprintf(stderr, "%s: %s\n", path, *error.text ? error.text : ndl_status_text(code));
    ndl_image_free(all);
    ndl_scene_free(scene);
    return code ? 1 : 0;
}
