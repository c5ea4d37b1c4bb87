/* SPDX-License-Identifier: Apache-2.0 */
/* What is claimed: claims.csv, written from the formulas, against ndl_material_claims of every
   combination of every model; for each law that a row leaves out a violation, evaluated again, of
   counterexamples.csv; and a table of golden values for every model. */
#include "../golden/golden_csv.h"
#include "directions.h"

enum { MOST_ROWS = 256, FEWEST_GOLDEN = 20, LAWS = 3 };
static const struct { const char *name; unsigned claim; } LAW[LAWS] = {
    {"reciprocity", NDL_CLAIM_RECIPROCITY},
    {"energy", NDL_CLAIM_ENERGY},
    {"continuity", NDL_CLAIM_CONTINUITY}};
/* The least violations that count: beyond what the law tests allow by far. */
static const double LEAST = 1e-3, SIZE_HOLDS_TO = 0.01;

typedef struct {
    char model[64], choices[128];
    unsigned claims, shown; /* shown: laws with a counterexample */
} claim_row;
static claim_row rows[MOST_ROWS];
static int row_count;

static unsigned law_bit(const char *name) {
    for (int i = 0; i < LAWS; i++)
        if (strcmp(LAW[i].name, name) == 0) return LAW[i].claim;
    print_error("'%s' is no law\n", name);
    fail();
    return 0;
}

static void read_rows(void) {
    enum { MODEL, CHOICES, CLAIMS, CELLS };
    golden_csv csv = golden_open("../laws/claims");
    golden_next(&csv); /* header */
    while (golden_next(&csv)) {
        claim_row *r = &rows[row_count++];
        assert_int_equal(csv.cells, CELLS);
        assert_true(row_count < MOST_ROWS);
        snprintf(r->model, sizeof r->model, "%s", csv.cell[MODEL]);
        snprintf(r->choices, sizeof r->choices, "%s", csv.cell[CHOICES]);
        for (char *law = strtok(csv.cell[CLAIMS], " "); law; law = strtok(NULL, " "))
            r->claims |= law_bit(law);
    }
}

/* " masking=none ramp=no ": the words of combination c. */
static void describe(size_t model, int c, char text[512]) {
    char word[64];
    size_t count;
    const ndl_param *p = ndl_model_params(model, &count);
    int n = snprintf(text, 512, " ");
    for (size_t k = count; k-- > 0;) {
        if (!is_choice(&p[k])) continue;
        bool ramp = p[k].kind == NDL_KIND_RAMP;
        int words = ramp ? 2 : word_count(p[k].words);
        const char *value = ramp ? (c % 2 ? "yes" : "no") : word_at(p[k].words, c % words, word);
        n += snprintf(text + n, (size_t)(512 - n), "%s=%s ", p[k].key, value);
        c /= words;
    }
}

/* Whether every word of a row's choices is one of the combination's. */
static bool fits(const claim_row *r, const char *model, const char *combination) {
    char choices[128], word[140];
    if (strcmp(r->model, model) != 0) return false;
    snprintf(choices, sizeof choices, "%s", r->choices);
    for (char *one = strtok(choices, " "); one; one = strtok(NULL, " ")) {
        snprintf(word, sizeof word, " %s ", one);
        if (!strstr(combination, word)) return false;
    }
    return true;
}

/* The text of the one material of a row that has a number key: false for a row of choices. */
static bool of_one_material(const claim_row *r, char text[256]) {
    char choices[128];
    size_t count;
    bool one = false;
    const ndl_param *p = ndl_model_params((size_t)ndl_model_find(r->model), &count);
    snprintf(text, 256, "%.63s(%.127s)", r->model, r->choices);
    for (char *blank; (blank = strchr(text, ' ')) != NULL;) *blank = ',';
    snprintf(choices, sizeof choices, "%s", r->choices);
    for (char *word = strtok(choices, " "); word; word = strtok(NULL, " "))
        for (size_t k = 0; k < count; k++) {
            size_t n = strlen(p[k].key);
            one |= !is_choice(&p[k]) && !strncmp(word, p[k].key, n) && word[n] == '=';
        }
    return one;
}

static const claim_row *row_of(const char *model, const char *combination) {
    const claim_row *found = NULL;
    for (int i = 0; i < row_count; i++)
        if (fits(&rows[i], model, combination)) found = &rows[i];
    return found;
}

/* ---- violations ------------------------------------------------------------------------------ */

/* The size of a violation as counterexamples.csv defines it. */
static double violation(const ndl_material *m, unsigned law, ndl_vec3 wi, ndl_vec3 wo) {
    double f = (double)ndl_brdf(m, wi, wo).r, g = (double)ndl_brdf(m, wo, wi).r;
    if (law == NDL_CLAIM_ENERGY) {
        float error;
        return (double)ndl_albedo(m, wo, 0.0f, &error).r - 1.0 - (double)error;
    }
    if (law == NDL_CLAIM_RECIPROCITY) return fmax(f, g) > 0.0 ? fabs(f - g) / fmax(f, g) : 0.0;
    assert_true(wi.z < 1e-8f);
    return (double)ndl_brdf_cos(m, wi, wo).r;
}

/* For a model without rows, which brings only its header: a law that it does not claim is broken
   somewhere in the box of its parameters. */
static bool breaks(size_t model, int c, unsigned law) {
    draws d = draws_of(model);
    for (unsigned i = 0; i < 64; i++) {
        ndl_material *m = vector_material(model, c, i, true);
        float a[3], b[3];
        direction_at(law == NDL_CLAIM_CONTINUITY ? 1e-9 : draw(&d), TURN * draw(&d), a);
        direction_at(pow(10.0, -3.0 * draw(&d)), TURN * draw(&d), b);
        ndl_vec3 wi = {a[0], a[1], a[2]}, wo = {b[0], b[1], b[2]};
        double size = violation(m, law, wi, wo);
        ndl_material_free(m);
        if (size > LEAST) return true;
    }
    return false;
}

/* ---- the tests ------------------------------------------------------------------------------- */

static void judge_combination(size_t model, int c) {
    const char *name = ndl_model_name(model);
    char combination[512];
    draws d = draws_of(0);
    recipe r = {.model = name};
    describe(model, c, combination);
    add_choices(&r, model, c, &d);
    ndl_material *m = material_of(&r);
    unsigned claims = ndl_material_claims(m);
    ndl_material_free(m);
    const claim_row *row = row_of(name, combination);
    for (int i = 0; i < LAWS; i++) {
        bool claimed = claims & LAW[i].claim;
        if (row && claimed != !!(row->claims & LAW[i].claim)) {
            print_error("%s (%s): the library %s %s, tests/laws/claims.csv does not\n", name,
                        combination, claimed ? "claims" : "does not claim", LAW[i].name);
            fail();
        }
        if (!row && !claimed && !breaks(model, c, LAW[i].claim)) {
            print_error("%s (%s): does not claim %s, but seems to keep it\n", name, combination,
                        LAW[i].name);
            fail();
        }
    }
}

static void the_library_claims_what_the_formulas_say(void **state) {
    size_t model = model_of(state);
    int axes, all = combinations(model, &axes), found = 0;
    for (int c = 0; c < all; c++) judge_combination(model, c);
    for (int i = 0; i < row_count; i++) found += !strcmp(rows[i].model, ndl_model_name(model));
    if (!found) print_message("no row in claims.csv: its header's claims stand\n");
}

static void every_model_has_golden_values(void **state) {
    golden_csv csv = golden_open(ndl_model_name(model_of(state)));
    int n = 0;
    while (golden_next(&csv)) n++;
    assert_true(n > FEWEST_GOLDEN);
}

static void judge_counterexample(const golden_csv *csv) {
    enum { MODEL, CHOICES, OF_LAW, MATERIAL, WI, WO = WI + 3, SIZE = WO + 3, CELLS };
    ndl_error err;
    assert_int_equal(csv->cells, CELLS);
    unsigned law = law_bit(csv->cell[OF_LAW]);
    ndl_material *m = ndl_material_parse(csv->cell[MATERIAL], &err);
    if (!m) fail_msg("line %d: %s", csv->number, err.text);
    ndl_vec3 wi = {(float)golden_number(csv, WI), (float)golden_number(csv, WI + 1),
                   (float)golden_number(csv, WI + 2)};
    ndl_vec3 wo = {(float)golden_number(csv, WO), (float)golden_number(csv, WO + 1),
                   (float)golden_number(csv, WO + 2)};
    double size = violation(m, law, wi, wo), stored = golden_number(csv, SIZE);
    print_message("line %d: %s breaks %s by %.6g\n", csv->number, csv->cell[MATERIAL],
                  csv->cell[OF_LAW], size);
    assert_true(size > LEAST);
    assert_close(size, stored, SIZE_HOLDS_TO, 0.0);
    assert_false(ndl_material_claims(m) & law);
    assert_string_equal(ndl_material_model(m, 0), csv->cell[MODEL]);
    ndl_material_free(m);
    for (int i = 0; i < row_count; i++)
        if (strcmp(rows[i].model, csv->cell[MODEL]) == 0 &&
            strcmp(rows[i].choices, csv->cell[CHOICES]) == 0)
            rows[i].shown |= law;
}

static void every_law_left_out_is_broken_by_a_counterexample(void **state) {
    (void)state;
    golden_csv csv = golden_open("../laws/counterexamples");
    golden_next(&csv); /* header */
    while (golden_next(&csv)) judge_counterexample(&csv);
    for (int i = 0; i < row_count; i++) {
        for (int k = 0; k < LAWS; k++) {
            bool claimed = rows[i].claims & LAW[k].claim, shown = rows[i].shown & LAW[k].claim;
            if (claimed == !shown) continue;
            print_error("%s (%s), %s: %s\n", rows[i].model, rows[i].choices, LAW[k].name,
                        claimed ? "claimed, but has a counterexample"
                                : "not claimed, but nothing in counterexamples.csv breaks it");
            fail();
        }
    }
}

static void the_claims_of_one_material_are_its_own(const char *text, unsigned claims) {
    ndl_error err;
    ndl_material *m = ndl_material_parse(text, &err);
    if (!m) fail_msg("%s: %s", text, err.text);
    if (ndl_material_claims(m) != claims) print_error("%s: not what claims.csv says\n", text);
    assert_int_equal(ndl_material_claims(m), claims);
    ndl_material_free(m);
}

static void every_row_names_a_model_and_its_choices(void **state) {
    (void)state;
    for (int i = 0; i < row_count; i++) {
        int model = ndl_model_find(rows[i].model), axes, used = 0;
        char text[256];
        assert_true(model >= 0);
        if (of_one_material(&rows[i], text)) {
            the_claims_of_one_material_are_its_own(text, rows[i].claims);
            continue;
        }
        for (int c = 0; c < combinations((size_t)model, &axes); c++) {
            char combination[512];
            describe((size_t)model, c, combination);
            used += row_of(rows[i].model, combination) == &rows[i];
        }
        if (!used) print_error("%s (%s): fits no combination\n", rows[i].model, rows[i].choices);
        assert_true(used > 0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_row_names_a_model_and_its_choices),
        cmocka_unit_test(every_law_left_out_is_broken_by_a_counterexample),
    };
    read_rows();
    int failed = cmocka_run_group_tests_name("counterexamples", tests, NULL, NULL);
    failed += run_over_models("claims", the_library_claims_what_the_formulas_say);
    return failed + run_over_models("golden values", every_model_has_golden_values);
}
