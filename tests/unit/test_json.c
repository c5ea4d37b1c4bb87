/* SPDX-License-Identifier: Apache-2.0 */
/* The JSON of random materials of every model, read by Python's parser and written as expressions
   by a few lines of Python, means the same material. */
#include "../laws/materials.h"

enum { VECTORS = 6, MOST = 4000 };

static const char READER[] =
    "import json, sys\n"
    "def text(key, v):\n"
    "    if isinstance(v, list) and key == 'ramp':\n"
    "        return '[' + ','.join(text('', x) + ':' + text('', c) for x, c in v) + ']'\n"
    "    if isinstance(v, list):\n"
    "        return '[' + ','.join(text('', x) for x in v) + ']'\n"
    "    return v if isinstance(v, str) else repr(float(v))\n"
    "for line in open(sys.argv[1]):\n"
    "    m = json.loads(line, parse_constant=lambda s: 1 / 0)\n"
    "    assert list(m) == ['lobes'], m\n"
    "    for lobe in m['lobes']:\n"
    "        assert list(lobe) == ['weight', 'model', 'params'], lobe\n"
    "        assert len(lobe['weight']) == 3, lobe\n"
    "    print('+'.join(text('', l['weight']) + '*' + l['model'] + '('\n"
    "                   + ','.join(k + '=' + text(k, v) for k, v in l['params'].items()) + ')'\n"
    "                   for l in m['lobes']))\n";

static ndl_material *all[MOST];
static int count;

static void collect(void) {
    for (size_t model = 0; model < ndl_model_count(); model++) {
        int axes, choices = combinations(model, &axes);
        for (int c = 0; c < choices; c++)
            for (unsigned v = 0; v < VECTORS && count + 1 < MOST; v++) {
                char text[TEXT_ROOM];
                ndl_material *m = vector_material(model, c, v + 100, false);
                all[count++] = m;
                snprintf(text, sizeof text, "[0.1,%d,3e-9]*%s + 0.5*lambert", c,
                         ndl_material_text(m));
                if (v == 0) all[count++] = ndl_material_parse(text, NULL);
            }
    }
}

static void python_reads_the_json_of_every_material(void **state) {
    (void)state;
    char json[] = "/tmp/ndl_json_XXXXXX", script[] = "/tmp/ndl_read_XXXXXX", command[200];
    FILE *file = fdopen(mkstemp(json), "w"), *reader = fdopen(mkstemp(script), "w");
    assert_true(file && reader);
    collect();
    for (int i = 0; i < count; i++) fprintf(file, "%s\n", ndl_material_json(all[i]));
    fputs(READER, reader);
    fclose(file);
    fclose(reader);
    snprintf(command, sizeof command, "python3 %s %s", script, json);
    FILE *back = popen(command, "r");
    assert_non_null(back);
    for (int i = 0; i < count; i++) {
        char line[TEXT_ROOM];
        if (!fgets(line, sizeof line, back)) fail_msg("no line for %s", ndl_material_json(all[i]));
        ndl_error err;
        ndl_material *m = ndl_material_parse(line, &err);
        if (!m) fail_msg("%s: column %d: %s", line, err.column, err.text);
        assert_string_equal(ndl_material_text(m), ndl_material_text(all[i]));
        ndl_material_free(m);
        ndl_material_free(all[i]);
    }
    assert_int_equal(pclose(back), 0);
    assert_int_equal(remove(json) | remove(script), 0);
    print_message("%d materials\n", count);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(python_reads_the_json_of_every_material)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
