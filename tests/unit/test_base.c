/* SPDX-License-Identifier: Apache-2.0 */
/* Arena, growing text, nearest names and the table of errors. */
#include "ndl_test.h"

#include "base/arena.h"
#include "base/error.h"
#include "base/nearest.h"
#include "base/text.h"

static void an_arena_gives_aligned_zeroed_memory(void **state) {
    (void)state;
    nd_arena a = {0};
    unsigned char *before = NULL;
    for (size_t size = 0; size < 3000; size += 7) {
        unsigned char *p = nd_arena_alloc(&a, size);
        assert_non_null(p);
        assert_true(p != before || size == 7);
        assert_int_equal((uintptr_t)p % sizeof(long double), 0);
        for (size_t i = 0; i < size; i++) assert_int_equal(p[i], 0);
        memset(p, 0xff, size);
        before = p;
    }
    unsigned char *big = nd_arena_alloc(&a, 1000000);
    assert_non_null(big);
    big[999999] = 1;
    assert_string_equal(nd_arena_text(&a, "abcdef", 3), "abc");
    assert_string_equal(nd_arena_text(&a, "", 0), "");
    assert_null(nd_arena_alloc(&a, SIZE_MAX));
    assert_null(nd_arena_alloc(&a, SIZE_MAX - 8));
    nd_arena_free(&a);
    nd_arena_free(&a);
    assert_non_null(nd_arena_alloc(&a, 1)); /* an emptied arena can be used again */
    nd_arena_free(&a);
}

static void text_grows(void **state) {
    (void)state;
    nd_text t = {0};
    for (int i = 0; i < 1000; i++) nd_text_add(&t, "0123456789");
    nd_text_bytes(&t, "abc", 2);
    assert_int_equal(t.n, 10002);
    char *s = nd_text_take(&t);
    assert_int_equal(strlen(s), 10002);
    assert_string_equal(s + 9999, "9ab");
    free(s);
    assert_null(t.s);
    s = nd_text_take(&t); /* nothing added is the empty text */
    assert_string_equal(s, "");
    free(s);
    nd_text_free(&t);
}

static void numbers_and_json_strings(void **state) {
    (void)state;
    nd_text t = {0};
    nd_text_int(&t, 0);
    nd_text_int(&t, -12);
    nd_text_int(&t, INT64_MIN);
    nd_text_int(&t, INT64_MAX);
    nd_text_float(&t, 0.1f);
    assert_string_equal(t.s, "0-12-922337203685477580892233720368547758070.1");
    nd_text_free(&t);
    nd_text_json(&t, "a\"b\\c\n\t\x01/\xc3\xa9");
    assert_string_equal(t.s, "\"a\\\"b\\\\c\\u000a\\u0009\\u0001/\xc3\xa9\"");
    nd_text_free(&t);
}

static const char *nearest_of(const char *wanted, const char *words, char room[64]) {
    nd_nearest near = {wanted, NULL, 0};
    nd_nearest_words(&near, words, room, 64);
    return near.best ? near.best : "";
}

static void the_nearest_name_is_found(void **state) {
    (void)state;
    char room[64];
    static const char keys[] =
        "alpha alpha_x alpha_y roughness anisotropy f0 ior eta k preset color";
    static const struct { const char *wanted, *best; } rows[] = {
        {"alhpa", "alpha"},    {"alfa", "alpha"},      {"rough", "roughness"}, {"ALPHA", "alpha"},
        {"colour", "color"},   {"f", "f0"},            {"fo", "f0"},           {"iro", "ior"},
        {"zzzzz", ""},         {"alpha_z", "alpha_x"}, {"", ""},               {"q", "k"},
        {"presets", "preset"}, {"ani", "anisotropy"},  {"roughnes", "roughness"}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (strcmp(nearest_of(rows[i].wanted, keys, room), rows[i].best) != 0)
            fail_msg("'%s' is near '%s', want '%s'", rows[i].wanted,
                     nearest_of(rows[i].wanted, keys, room), rows[i].best);
    char endless[300];
    memset(endless, 'a', sizeof endless - 1);
    endless[sizeof endless - 1] = '\0';
    assert_string_equal(nearest_of(endless, keys, room), "");
    assert_string_equal(nearest_of("ab", endless, room), "");
}

static void every_status_has_its_own_sentence(void **state) {
    (void)state;
    assert_string_equal(ndl_status_text(NDL_OK), "success");
    for (int i = 0; i < NDL_STATUS_COUNT; i++) {
        const char *text = ndl_status_text(i);
        assert_true(strlen(text) > 3);
        assert_string_not_equal(text, "unknown status");
        for (int k = 0; k < i; k++) assert_string_not_equal(text, ndl_status_text(k));
    }
    assert_string_equal(ndl_status_text(-1), "unknown status");
    assert_string_equal(ndl_status_text(NDL_STATUS_COUNT), "unknown status");
}

static void a_failure_joins_its_parts(void **state) {
    (void)state;
    ndl_error e;
    char parts[200];
    assert_false(nd_fail(NULL, NDL_E_RANGE, 1, "lost", NULL));
    assert_false(nd_fail(&e, NDL_E_RANGE, 7, "a ", "b", "", "c", NULL));
    assert_int_equal(e.code, NDL_E_RANGE);
    assert_int_equal(e.column, 7);
    assert_string_equal(e.text, "a bc");
    memset(parts, 'x', sizeof parts - 1);
    parts[sizeof parts - 1] = '\0';
    nd_fail(&e, NDL_E_RANGE, 7, parts, parts, parts, NULL); /* cut, not written past the end */
    assert_int_equal(strlen(e.text), sizeof e.text - 1);
}

static void quoted_tokens_are_printable_and_short(void **state) {
    (void)state;
    char room[24];
    assert_string_equal(nd_quote("alpha", 5, room, sizeof room), "alpha");
    assert_string_equal(nd_quote("a\n\xff", 3, room, sizeof room), "a\\x0a\\xff");
    assert_string_equal(nd_quote("0123456789abcdefghijklmnop", 26, room, sizeof room),
                        "0123456789abcdefg...");
    assert_string_equal(nd_quote("", 0, room, sizeof room), "");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_arena_gives_aligned_zeroed_memory),
        cmocka_unit_test(text_grows),
        cmocka_unit_test(numbers_and_json_strings),
        cmocka_unit_test(the_nearest_name_is_found),
        cmocka_unit_test(every_status_has_its_own_sentence),
        cmocka_unit_test(a_failure_joins_its_parts),
        cmocka_unit_test(quoted_tokens_are_printable_and_short),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
