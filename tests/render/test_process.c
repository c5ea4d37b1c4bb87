/* SPDX-License-Identifier: Apache-2.0 */
/* Child processes with limits, files whole or not at all, and numbered jobs on threads. */
#include "ndl_test.h"

#include "base/file.h"
#include "base/process.h"
#include "base/threads.h"

#include <signal.h>
#include <unistd.h>

typedef struct {
    size_t size;
    int code;
} speech;

static int speak(void *context, int out) {
    const speech *s = context;
    unsigned char *bytes = malloc(s->size + 1);
    for (size_t i = 0; i < s->size; i++) bytes[i] = (unsigned char)(i * i >> 3);
    bool sent = nd_child_write(out, bytes, s->size);
    free(bytes);
    return sent ? s->code : 99;
}

static void what_a_child_writes_arrives(void **state) {
    (void)state;
    const size_t sizes[] = {0, 1, 65536, 3000001};
    for (size_t k = 0; k < 4; k++) {
        nd_child child = nd_child_run(speak, &(speech){sizes[k], 7}, (nd_limits){0});
        assert_int_equal(child.end, ND_CHILD_DONE);
        assert_int_equal(child.code, 7);
        assert_int_equal(child.count, sizes[k]);
        for (size_t i = 0; i < child.count; i++)
            assert_int_equal(child.bytes[i], (unsigned char)(i * i >> 3));
        free(child.bytes);
    }
}

static int crash(void *context, int out) {
    (void)context;
    nd_child_write(out, "half", 4);
    return raise(SIGKILL);
}

static int spin(void *context, int out) {
    volatile int *going = context;
    while (*going) {}
    return out;
}

static int sleep_long(void *context, int out) {
    (void)context;
    (void)out;
    return (int)sleep(60);
}

static int hoard(void *context, int out) {
    (void)context;
    (void)out;
    void *volatile block = malloc((size_t)3 << 30); /* volatile: or clang leaves malloc out */
    return block ? 1 : 0;
}

static void limits_end_a_child(void **state) {
    (void)state;
    int going = 1;
    nd_child child = nd_child_run(crash, NULL, (nd_limits){0});
    assert_int_equal(child.end, ND_CHILD_CRASHED);
    assert_int_equal(child.code, SIGKILL);
    assert_null(child.bytes);
    double start = nd_clock();
    child = nd_child_run(spin, &going, (nd_limits){.seconds = 0.3});
    assert_int_equal(child.end, ND_CHILD_TOO_SLOW);
    child = nd_child_run(sleep_long, NULL, (nd_limits){.seconds = 0.3});
    assert_int_equal(child.end, ND_CHILD_TOO_SLOW);
    assert_true(nd_clock() - start < 20.0);
    child = nd_child_run(speak, &(speech){1000000, 0}, (nd_limits){.output = 999999});
    assert_int_equal(child.end, ND_CHILD_TOO_LONG);
    assert_null(child.bytes);
    child = nd_child_run(speak, &(speech){1000000, 0}, (nd_limits){.output = 1000000});
    assert_int_equal(child.end, ND_CHILD_DONE);
    free(child.bytes);
}

static void memory_beyond_the_limit_is_refused(void **state) {
    (void)state;
    const char *sanitizers = getenv("NDOTL_SANITIZE");
    if (sanitizers && *sanitizers) return; /* their shadow memory forbids the limit */
    nd_child child = nd_child_run(hoard, NULL, (nd_limits){.memory = (size_t)1 << 30});
    assert_int_equal(child.end, ND_CHILD_DONE);
    assert_int_equal(child.code, 0);
}

static void a_file_is_replaced_whole(void **state) {
    (void)state;
    char path[] = "replaced_XXXXXX";
    int file = mkstemp(path);
    assert_true(file >= 0);
    close(file);
    ndl_error error = {0};
    assert_true(nd_file_replace(path, "first", 5, &error));
    assert_true(nd_file_replace(path, "new", 3, &error));
    char text[8] = {0};
    FILE *f = fopen(path, "rb");
    assert_int_equal(fread(text, 1, sizeof text, f), 3);
    fclose(f);
    assert_string_equal(text, "new");
    assert_true(nd_file_readable(path, &error));
    remove(path);
    assert_int_equal(error.code, NDL_OK);
    assert_false(nd_file_readable(path, &error));
    assert_int_equal(error.code, NDL_E_FILE);
    assert_false(nd_file_readable("/", &error));
    assert_false(nd_file_readable("/dev/null", &error));
    assert_true(nd_file_replace("/dev/null", "x", 1, &error));
    assert_false(nd_file_replace("no/such/folder/x", "x", 1, &error));
    assert_int_equal(error.code, NDL_E_FILE);
}

enum { ITEMS = 1000 };
typedef struct {
    int times[ITEMS];
    size_t last, stop_at;
    bool in_order;
} tally;

static void count(void *context, int thread, size_t item) {
    tally *t = context;
    assert_in_range(thread, 0, 15);
    t->times[item]++;
}

static bool after(void *context, size_t items) {
    tally *t = context;
    t->in_order &= items == t->last + 1;
    t->last = items;
    return items != t->stop_at;
}

static void every_job_is_done_once(void **state) {
    (void)state;
    for (int threads = 1; threads <= 16; threads += 5) {
        tally t = {.in_order = true};
        assert_true(nd_jobs_run(&(nd_jobs){ITEMS, count, after, &t}, threads));
        for (int i = 0; i < ITEMS; i++) assert_int_equal(t.times[i], 1);
        assert_true(t.in_order && t.last == ITEMS);
    }
    assert_true(nd_jobs_run(&(nd_jobs){0, count, NULL, NULL}, 4));
    assert_in_range(nd_processors(), 1, ND_MOST_THREADS);
}

static void jobs_stop_when_told(void **state) {
    (void)state;
    tally t = {.in_order = true, .stop_at = 10};
    assert_false(nd_jobs_run(&(nd_jobs){ITEMS, count, after, &t}, 4));
    int done = 0;
    for (int i = 0; i < ITEMS; i++) done += t.times[i];
    assert_in_range(done, 10, 14);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_a_child_writes_arrives),
        cmocka_unit_test(limits_end_a_child),
        cmocka_unit_test(memory_beyond_the_limit_is_refused),
        cmocka_unit_test(a_file_is_replaced_whole),
        cmocka_unit_test(every_job_is_done_once),
        cmocka_unit_test(jobs_stop_when_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
