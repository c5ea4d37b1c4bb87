/* SPDX-License-Identifier: Apache-2.0 */
/* What comes from the importing child is not trusted: every damage is an error, not a crash. */
#include "ndl_test.h"

#include "io/mesh.h"

/* A packed square of two triangles in two parts. */
static unsigned char *packed_square(size_t *size) {
    static const float corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    static const uint32_t index[6] = {0, 1, 2, 0, 2, 3};
    nd_mesh m;
    assert_true(nd_mesh_new(&m, 4, 2, 2, false));
    for (int i = 0; i < 4; i++) {
        memcpy(m.position + 3 * i, corner[i], sizeof corner[i]);
        m.normal[3 * i + 2] = 1.0f;
    }
    memcpy(m.index, index, sizeof index);
    m.part[0].count = m.part[1].count = m.part[1].first = 1;
    strcpy(m.part[0].mesh, "one");
    nd_mesh_head head = {ND_MESH_MAGIC, 4, 2, 2};
    memcpy(m.storage, &head, sizeof head);
    *size = (size_t)((unsigned char *)(m.index + 6) - (unsigned char *)m.storage);
    return m.storage;
}

static nd_mesh *mesh_of(unsigned char *bytes) {
    static nd_mesh m;
    m = (nd_mesh){0};
    unsigned char *part = bytes + sizeof(nd_mesh_head);
    m.part = (nd_part *)(void *)part;
    m.position = (float *)(void *)(part + 2 * sizeof(nd_part));
    m.normal = m.position + 12;
    m.uv = m.normal + 12;
    m.index = (uint32_t *)(void *)(m.uv + 8);
    return &m;
}

static void a_whole_mesh_is_taken(void **state) {
    (void)state;
    size_t size;
    nd_mesh m;
    ndl_error error = {0};
    unsigned char *bytes = packed_square(&size);
    mesh_of(bytes)->part[0].metalness = (float)NAN;
    mesh_of(bytes)->part[0].roughness = 7.0f;
    mesh_of(bytes)->uv[3] = (float)INFINITY;
    memset(mesh_of(bytes)->part[1].material, 'x', ND_NAME);
    assert_true(nd_mesh_unpack(bytes, size, &m, &error));
    assert_int_equal(m.triangles, 2);
    assert_string_equal(m.part[0].mesh, "one");
    assert_int_equal(strlen(m.part[1].material), ND_NAME - 1);
    assert_true(m.part[0].metalness == 1.0f && m.part[0].roughness == 1.0f);
    assert_true(m.uv[2] == 0.0f && m.uv[3] == 0.0f);
    nd_mesh_free(&m);
}

static void expect_refusal(unsigned char *bytes, size_t size, const char *reason) {
    nd_mesh m;
    ndl_error error = {0};
    assert_false(nd_mesh_unpack(bytes, size, &m, &error));
    assert_int_equal(error.code, NDL_E_FILE);
    if (!strstr(error.text, reason)) {
        print_error("'%s' lacks '%s'\n", error.text, reason);
        fail();
    }
    assert_null(m.storage);
}

static void damage_is_refused(void **state) {
    (void)state;
    size_t size;
    unsigned char *bytes = packed_square(&size);
    mesh_of(bytes)->position[4] = (float)NAN;
    expect_refusal(bytes, size, "not finite");
    bytes = packed_square(&size);
    mesh_of(bytes)->position[4] = -2e15f;
    expect_refusal(bytes, size, "beyond 1e15");
    bytes = packed_square(&size);
    mesh_of(bytes)->index[2] = 4;
    expect_refusal(bytes, size, "vertex that is missing");
    bytes = packed_square(&size);
    mesh_of(bytes)->part[1].count = 0xffffffffu;
    expect_refusal(bytes, size, "malformed");
    bytes = packed_square(&size);
    mesh_of(bytes)->part[1].first = 0;
    expect_refusal(bytes, size, "malformed");
    bytes = packed_square(&size);
    for (int i = 0; i < 6; i++) mesh_of(bytes)->index[i] = 3;
    expect_refusal(bytes, size, "no triangle with an area");
    expect_refusal(NULL, 0, "malformed");
}

static void every_cut_and_every_count_is_refused(void **state) {
    (void)state;
    size_t size;
    free(packed_square(&size));
    for (size_t cut = 0; cut < size; cut++) {
        unsigned char *bytes = packed_square(&size);
        expect_refusal(bytes, cut, "malformed");
    }
    static const uint32_t counts[] = {0, 3, 5, 0x7fffffffu, 0x80000000u, 0xffffffffu};
    for (size_t field = 1; field < 4; field++)
        for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
            unsigned char *bytes = packed_square(&size);
            memcpy(bytes + 4 * field, &counts[i], 4);
            expect_refusal(bytes, size, "malformed");
        }
}

static void the_reason_of_a_refusal_is_quoted(void **state) {
    (void)state;
    static const char reason[] = "no\033[31m";
    const uint32_t magic = ND_MESH_REFUSED;
    unsigned char *bytes = malloc(sizeof magic + sizeof reason);
    memcpy(bytes, &magic, sizeof magic);
    memcpy(bytes + sizeof magic, reason, sizeof reason);
    expect_refusal(bytes, sizeof magic + sizeof reason - 1, "no\\x1b[31m");
}

static void degenerate_triangles_leave_their_part(void **state) {
    (void)state;
    size_t size;
    nd_mesh m;
    ndl_error error = {0};
    unsigned char *bytes = packed_square(&size);
    mesh_of(bytes)->index[1] = 0;
    assert_true(nd_mesh_unpack(bytes, size, &m, &error));
    assert_int_equal(m.triangles, 1);
    assert_int_equal(m.part[0].count, 0);
    assert_int_equal(m.part[1].first, 0);
    assert_int_equal(m.part[1].count, 1);
    assert_int_equal(m.index[2], 3);
    nd_mesh_free(&m);
}

static void import_honours_its_limits(void **state) {
    (void)state;
    static const char path[] = "limited.obj";
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    for (int i = 0; i < 200000; i++) fprintf(f, "v %d %d 0\n", i % 7, i % 11);
    for (int i = 1; i < 199999; i += 3) fprintf(f, "f %d %d %d\n", i, i + 1, i + 2);
    fclose(f);
    nd_mesh m;
    ndl_error error = {0};
    assert_false(nd_mesh_import(path, (nd_limits){.seconds = 1e-3}, &m, &error));
    assert_int_equal(error.code, NDL_E_LIMIT);
    assert_false(nd_mesh_import(path, (nd_limits){.output = 1000}, &m, &error));
    assert_int_equal(error.code, NDL_E_LIMIT);
    assert_true(nd_mesh_import(path, (nd_limits){.seconds = 60.0}, &m, &error));
    nd_mesh_free(&m);
    remove(path);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_whole_mesh_is_taken),
        cmocka_unit_test(damage_is_refused),
        cmocka_unit_test(every_cut_and_every_count_is_refused),
        cmocka_unit_test(the_reason_of_a_refusal_is_quoted),
        cmocka_unit_test(degenerate_triangles_leave_their_part),
        cmocka_unit_test(import_honours_its_limits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
