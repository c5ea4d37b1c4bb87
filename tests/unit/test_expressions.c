/* SPDX-License-Identifier: Apache-2.0 */
/* The grammar of expressions: what is read, as what, and what is refused with which words at which
   column. The tables are expressions.txt and expression_errors.txt. */
#include "table.h"

#include <ndotl/ndotl.h>

static int status_of(const char *name) {
    static const struct { const char *name; int code; } all[] = {
#define NDL_ERROR(code, text) {#code, NDL_E_##code},
#include "ndotl/errors.def"
#undef NDL_ERROR
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        if (strcmp(all[i].name, name) == 0) return all[i].code;
    fail_msg("'%s' is no status", name);
    return -1;
}

static void texts_are_read_and_printed(void **state) {
    (void)state;
    table_row row = {.number = 0};
    FILE *file = open_table("expressions.txt");
    int rows = 0;
    for (; next_row(file, &row); rows++) {
        ndl_error err;
        ndl_material *m = ndl_material_parse(row.left, &err);
        if (!m) fail_msg("line %d: column %d: %s", row.number, err.column, err.text);
        assert_int_equal(err.code, NDL_OK);
        assert_string_equal(ndl_material_text(m), row.right);
        ndl_material_free(m);
    }
    assert_true(rows > 20);
}

static void mistakes_are_named_where_they_are(void **state) {
    (void)state;
    table_row row = {.number = 0};
    FILE *file = open_table("expression_errors.txt");
    int rows = 0, wrong = 0;
    for (; next_row(file, &row); rows++) {
        ndl_error err;
        ndl_material *m = ndl_material_parse(row.left, &err);
        if (m) fail_msg("line %d: '%s' is accepted", row.number, row.left);
        char name[32] = "", want[400] = "";
        int column = 0, used = 0;
        assert_int_equal(sscanf(row.right, "%31s %d %n", name, &column, &used), 2);
        snprintf(want, sizeof want, "%s", row.right + used);
        if (err.code == status_of(name) && err.column == column && strcmp(err.text, want) == 0)
            continue;
        wrong++;
        print_error("line %d: '%s'\n  gives status %d, column %d: %s\n  want %s\n", row.number,
                    row.left, err.code, err.column, err.text, row.right);
    }
    assert_int_equal(wrong, 0);
    assert_true(rows > 100);
}

static void the_error_may_be_left_out(void **state) {
    (void)state;
    assert_null(ndl_material_parse("nonsense(", NULL));
    assert_null(ndl_material_parse(NULL, NULL));
    ndl_material *m = ndl_material_parse("lambert", NULL);
    assert_non_null(m);
    ndl_material_free(m);
    ndl_material_free(NULL);
}

/* Every beginning of a text, and the text with any one byte exchanged, is read or refused with a
   column inside the text. */
static void broken_texts_are_refused_inside(void **state) {
    (void)state;
    static const char text[] =
        "[.5,1,2]*ggx(preset=gold,roughness=3e-1) + toon_diffuse(ramp=[0:#ff8800])";
    static const char bytes[] = "()[]=*+,:#.-eax9 \n\x80";
    for (size_t n = 0; n < sizeof text; n++) {
        for (size_t b = 0; b < sizeof bytes; b++) {
            char broken[sizeof text];
            ndl_error err;
            memcpy(broken, text, sizeof text);
            if (b + 1 < sizeof bytes) broken[n] = n + 1 < sizeof text ? bytes[b] : '\0';
            else broken[n] = '\0';
            ndl_material *m = ndl_material_parse(broken, &err);
            if (!m) {
                assert_int_not_equal(err.code, NDL_OK);
                assert_in_range(err.column, 1, strlen(broken) + 1);
                assert_true(strlen(err.text) > 0);
            }
            ndl_material_free(m);
        }
    }
}

static void long_texts_are_read(void **state) {
    (void)state;
    enum { LOBES = 3000, STOPS = 200 };
    char *text = malloc(LOBES * 16 + STOPS * 32 + 100), *at = text;
    assert_non_null(text);
    for (int i = 0; i < LOBES; i++) at += sprintf(at, "%slambert", i ? "+" : "");
    ndl_material *m = ndl_material_parse(text, NULL);
    assert_non_null(m);
    assert_int_equal(ndl_material_lobes(m), LOBES);
    ndl_material_free(m);
    at = text + sprintf(text, "toon_diffuse(ramp=[");
    for (int i = 0; i < STOPS; i++) at += sprintf(at, "%s%d:%d", i ? "," : "", i, i % 7);
    sprintf(at, "])");
    m = ndl_material_parse(text, NULL);
    assert_non_null(m);
    ndl_material_free(m);
    free(text);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(texts_are_read_and_printed),
        cmocka_unit_test(mistakes_are_named_where_they_are),
        cmocka_unit_test(the_error_may_be_left_out),
        cmocka_unit_test(broken_texts_are_refused_inside),
        cmocka_unit_test(long_texts_are_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
