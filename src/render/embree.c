/* SPDX-License-Identifier: Apache-2.0 */
/* Embree 3 or 4: the same calls but for the arguments of the two queries. */
#include "render/tracer.h"

#include "base/error.h"

#if defined(__has_include)
#if __has_include(<embree4/rtcore.h>) && !__has_include(<embree3/rtcore.h>)
#include <embree4/rtcore.h>
#define EMBREE 4
#endif
#endif
#ifndef EMBREE
#include <embree3/rtcore.h>
#define EMBREE 3
#endif

#include <stdlib.h>
#include <string.h>

struct nd_tracer {
    RTCDevice device;
    RTCScene scene;
};

static bool attach(nd_tracer *t, const nd_mesh *m) {
    RTCGeometry g = rtcNewGeometry(t->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float *position = rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                              3 * sizeof(float), m->vertices);
    unsigned *index = rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                              3 * sizeof(unsigned), m->triangles);
    if (position && index) {
        memcpy(position, m->position, 3 * (size_t)m->vertices * sizeof *position);
        memcpy(index, m->index, 3 * (size_t)m->triangles * sizeof *index);
        rtcCommitGeometry(g);
        rtcAttachGeometry(t->scene, g);
    }
    rtcReleaseGeometry(g);
    return position && index;
}

nd_tracer *nd_tracer_new(const nd_mesh *m, ndl_error *error) {
    nd_tracer *t = calloc(1, sizeof *t);
    if (t) t->device = rtcNewDevice("threads=1");
    if (t && t->device) t->scene = rtcNewScene(t->device);
    if (t && t->scene) {
        rtcSetSceneFlags(t->scene, RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(t->scene, RTC_BUILD_QUALITY_MEDIUM);
        if (attach(t, m)) rtcCommitScene(t->scene);
        if (rtcGetDeviceError(t->device) == RTC_ERROR_NONE) return t;
    }
    nd_tracer_free(t);
    nd_fail(error, NDL_E_MEMORY, 0, "out of memory for ray tracing", NULL);
    return NULL;
}

void nd_tracer_free(nd_tracer *t) {
    if (!t) return;
    if (t->scene) rtcReleaseScene(t->scene);
    if (t->device) rtcReleaseDevice(t->device);
    free(t);
}

static struct RTCRay to_ray(nd_ray ray, double distance) {
    struct RTCRay r;
    memset(&r, 0, sizeof r);
    r.org_x = (float)ray.origin.x;
    r.org_y = (float)ray.origin.y;
    r.org_z = (float)ray.origin.z;
    r.dir_x = (float)ray.direction.x;
    r.dir_y = (float)ray.direction.y;
    r.dir_z = (float)ray.direction.z;
    r.tfar = (float)distance;
    r.mask = ~0u;
    return r;
}

bool nd_tracer_hit(const nd_tracer *t, nd_ray ray, uint32_t *triangle) {
    struct RTCRayHit query;
    memset(&query, 0, sizeof query);
    query.ray = to_ray(ray, (double)INFINITY);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if EMBREE == 4
    rtcIntersect1(t->scene, &query, NULL);
#else
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(t->scene, &context, &query);
#endif
    *triangle = query.hit.primID;
    return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

bool nd_tracer_blocked(const nd_tracer *t, nd_ray ray, double distance) {
    struct RTCRay query = to_ray(ray, distance);
#if EMBREE == 4
    rtcOccluded1(t->scene, &query, NULL);
#else
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(t->scene, &context, &query);
#endif
    return query.tfar < 0.0f;
}
