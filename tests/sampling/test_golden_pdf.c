/* SPDX-License-Identifier: Apache-2.0 */
/* ndl_pdf against the independent high-precision values of tests/golden/pdf.csv, within
   (16 + 4k) 2^-23 of the exact value, on every instruction set that this machine has. */
#include "../golden/golden_csv.h"

#include <math.h>
#include <ndotl/ndotl.h>

enum { MATERIAL = 1, QUANTITY, WI, WO = WI + 3, VALUE = WO + 3, K = VALUE + 3, CELLS = K + 3 };

static ndl_vec3 direction(const golden_csv *row, int cell) {
    ndl_vec3 w = {strtof(row->cell[cell], NULL), strtof(row->cell[cell + 1], NULL),
                  strtof(row->cell[cell + 2], NULL)};
    return w;
}

/* The error as a share of the bound; a large number where the row is none. */
static double judge(const golden_csv *row, const char *isa) {
    ndl_error err;
    ndl_material *m = row->cells == CELLS ? ndl_material_parse(row->cell[MATERIAL], &err) : NULL;
    if (!m || strcmp(row->cell[QUANTITY], "pdf") != 0) {
        printf("pdf.csv:%d: no density of a material\n", row->number);
        ndl_material_free(m);
        return 1e30;
    }
    double got = (double)ndl_pdf(m, direction(row, WI), direction(row, WO));
    double exact = golden_number(row, VALUE);
    double bound = (16.0 + 4.0 * golden_number(row, K)) * 0x1p-23 * exact + 1e-37;
    double share = got >= 0.0 ? fabs(got - exact) / bound : 1e30;
    ndl_material_free(m);
    if (share <= 1.0) return share;
    printf("pdf.csv:%d %s: got %.9g, exact %.9g, %.3g of the bound\n  reproduce: echo %s %s %s %s "
           "%s %s | NDOTL_ISA=%s ndotl eval '%s' --pdf\n",
           row->number, isa, got, exact, share, row->cell[WI], row->cell[WI + 1], row->cell[WI + 2],
           row->cell[WO], row->cell[WO + 1], row->cell[WO + 2], isa, row->cell[MATERIAL]);
    return share;
}

static bool passes(const char *isa) {
    double worst = 0.0;
    long values = 0;
    golden_csv row = golden_open("pdf");
    golden_next(&row); /* header */
    for (; golden_next(&row); values++)
        worst = fmax(worst, judge(&row, isa));
    printf("%-10s %ld densities, worst %.3f of the bound\n", isa, values, worst);
    return values > 300 && worst <= 1.0;
}

int main(void) {
    static const char *const isas[] = {"scalar", "x86-64", "x86-64-v3", "x86-64-v4", "neon"};
    bool good = true;
    for (size_t i = 0; i < sizeof isas / sizeof *isas; i++)
        if (ndl_use_isa(isas[i]) == NDL_OK) good &= passes(isas[i]);
    return good ? 0 : 1;
}
