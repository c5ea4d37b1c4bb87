/* SPDX-License-Identifier: Apache-2.0 */
/* Every model against the independent high-precision values of tests/golden/<model>.csv, within
   (16 + 4k) 2^-23 of the exact value (contract of accuracy); on every instruction set that this
   machine has. With an argument, only that table. */
#include "golden_csv.h"

#include <float.h>
#include <math.h>
#include <ndotl/ndotl.h>

enum { TAG, MATERIAL, QUANTITY, WI, WO = WI + 3, VALUE = WO + 3, K = VALUE + 3, CELLS = K + 3 };

/* The most that a test may loosen k: 2 % of a table's values may have a larger one. */
static const double K_LARGE = 1000.0, K_LARGE_SHARE = 0.02;

typedef struct {
    long values, failures, large_k;
    double worst, largest_k; /* worst: error as a share of the bound */
} tally;

static ndl_rgb compute(const ndl_material *m, const char *quantity, ndl_vec3 wi, ndl_vec3 wo) {
    if (strcmp(quantity, "brdf") == 0) return ndl_brdf(m, wi, wo);
    if (strcmp(quantity, "cos") == 0) return ndl_brdf_cos(m, wi, wo);
    if (strcmp(quantity, "scanline") == 0) return ndl_scanline(m, wi, wo);
    ndl_term_kind term = quantity[0] == 'D'   ? NDL_TERM_D
                         : quantity[0] == 'G' ? NDL_TERM_G
                         : quantity[0] == 'V' ? NDL_TERM_V
                                              : NDL_TERM_F;
    return ndl_term(m, term, wi, wo);
}

/* The interpolated table is held to 1e-3 in f cos, everything else to its condition number. */
static double bound_of(const golden_csv *row, double exact, double k) {
    if (strstr(row->cell[MATERIAL], "variant=table")) {
        double cosine = strcmp(row->cell[QUANTITY], "brdf") == 0 ? golden_number(row, WI + 2) : 1.0;
        double pi = strcmp(row->cell[QUANTITY], "scanline") == 0 ? 3.14159265358979 : 1.0;
        return 1e-3 * pi / fmax(cosine, 1e-3) + 1e-37;
    }
    return (16.0 + 4.0 * k) * 0x1p-23 * fabs(exact) + 1e-37;
}

static void judge(const golden_csv *row, const char *table, const char *isa, int channel, float got,
                  tally *t) {
    double exact = golden_number(row, VALUE + channel), k = golden_number(row, K + channel);
    if (exact > (double)FLT_MAX) exact = (double)FLT_MAX;
    double error = fabs((double)got - exact), bound = bound_of(row, exact, k);
    bool may_vanish = exact < 1e-20 && got == 0.0f;
    t->values++;
    t->large_k += k > K_LARGE;
    t->largest_k = fmax(t->largest_k, k);
    if (!may_vanish) t->worst = fmax(t->worst, error / bound);
    if (may_vanish || (error <= bound && got >= 0.0f)) return;
    if (t->failures++ < 10)
        printf("%s.csv:%d (%s, %s) %s %s, channel %d: got %.9g, exact %.9g, k %g, %.3g of the "
               "bound\n  reproduce: echo %s %s %s %s %s %s | ndotl eval '%s'\n",
               table, row->number, row->cell[TAG], isa, row->cell[MATERIAL], row->cell[QUANTITY],
               channel, (double)got, exact, k, error / bound, row->cell[WI], row->cell[WI + 1],
               row->cell[WI + 2], row->cell[WO], row->cell[WO + 1], row->cell[WO + 2],
               row->cell[MATERIAL]);
}

static ndl_vec3 direction(const golden_csv *row, int cell) {
    ndl_vec3 w = {strtof(row->cell[cell], NULL), strtof(row->cell[cell + 1], NULL),
                  strtof(row->cell[cell + 2], NULL)};
    return w;
}

static tally check_table(const char *table, const char *isa) {
    tally t = {0};
    golden_csv row = golden_open(table);
    golden_next(&row); /* header */
    while (golden_next(&row)) {
        ndl_error err;
        ndl_material *m = row.cells == CELLS ? ndl_material_parse(row.cell[MATERIAL], &err) : NULL;
        if (!m) {
            printf("%s.csv:%d: %s\n", table, row.number,
                   row.cells == CELLS ? err.text : "a row of another length");
            t.failures++;
            continue;
        }
        ndl_rgb f = compute(m, row.cell[QUANTITY], direction(&row, WI), direction(&row, WO));
        judge(&row, table, isa, 0, f.r, &t);
        judge(&row, table, isa, 1, f.g, &t);
        judge(&row, table, isa, 2, f.b, &t);
        ndl_material_free(m);
    }
    return t;
}

static bool passes(const char *table, const char *isa) {
    tally t = check_table(table, isa);
    bool few_large = t.large_k <= (long)(K_LARGE_SHARE * (double)t.values);
    printf("%-14s %-10s %6ld values, worst %.3f of the bound, largest k %.3g, %ld failed\n", table,
           isa, t.values, t.worst, t.largest_k, t.failures);
    if (!few_large) printf("%s: %ld values have k > %g\n", table, t.large_k, K_LARGE);
    if (t.values == 0) printf("%s: the table is empty\n", table);
    return t.failures == 0 && few_large && t.values > 0;
}

int main(int argc, char **argv) {
    static const char *const isas[] = {"scalar", "x86-64", "x86-64-v3", "x86-64-v4", "neon"};
    bool good = true;
    for (size_t i = 0; i < sizeof isas / sizeof *isas; i++) {
        if (ndl_use_isa(isas[i]) != NDL_OK) continue;
        if (argc > 1) good &= passes(argv[1], isas[i]);
        for (size_t k = 0; argc <= 1 && k < ndl_model_count(); k++)
            good &= passes(ndl_model_name(k), isas[i]);
        if (argc <= 1) good &= passes("sums", isas[i]);
    }
    return good ? 0 : 1;
}
