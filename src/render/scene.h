/* SPDX-License-Identifier: Apache-2.0 */
#ifndef ND_RENDER_SCENE_H
#define ND_RENDER_SCENE_H
#include "ndotl/render.h"
#include "render/camera.h"
#include "render/geometry.h"
#include "render/lights.h"

struct ndl_scene {
    nd_geometry geometry;
    const ndl_material **material; /* of each part */
    ndl_material **own;            /* made from the file's factors; NULL where there are none */
    ndl_material *plain;           /* lambert, for the others */
    nd_light *light;
    size_t lights;
    bool has_own_lights;
    nd_camera camera;
};

#endif
