/* SPDX-License-Identifier: Apache-2.0 */
/* Materials: from text to lobes, and changed copies. */
#include "core/material.h"

#include "base/error.h"
#include "base/nearest.h"
#include "core/draw.h"
#include "core/models.h"
#include "core/print.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool out_of_memory(ndl_error *error) {
    return nd_fail(error, NDL_E_MEMORY, 0, "out of memory", NULL);
}

/* ---- what a lobe's words select -------------------------------------------------------------- */

/* The combination of a model's choices, the last one counting fastest; a ramp is one more choice
   of two: absent, present. */
static int combination(const nd_binding *b) {
    int at = 0;
    for (size_t i = 0; i < b->schema->count; i++) {
        const ndl_param *p = &b->schema->params[i];
        if (p->kind == NDL_KIND_RAMP) at = 2 * at + (b->given[i] != NULL);
        if (p->kind != NDL_KIND_CHOICE || p->is_spelling) continue;
        int words = 1;
        for (const char *s = p->words; *s; s++) words += *s == ' ';
        at = words * at + b->choice[i];
    }
    return at;
}

/* Laws that a composition claims. Without masking the albedo has no bound. The Lambda of a narrower
   tail than the ndf's hides too little: Beckmann's with blinn, Walter's fit of it with ggx; and
   Neumann's min(NoL, NoV) hides too little of surfaces wider than any real one. */
static unsigned facet_claims(nd_facet f, const microfacet_p *p) {
    const unsigned gains = NDL_CLAIM_RECIPROCITY | NDL_CLAIM_CONTINUITY;
    bool smith = f.masking == ND_MASKING_IS_smith || f.masking == ND_MASKING_IS_smith_correlated;
    bool walter = f.masking == ND_MASKING_IS_smith_walter;
    if (f.masking == ND_MASKING_IS_none) return NDL_CLAIM_RECIPROCITY;
    if (f.ndf == ND_NDF_IS_blinn && (smith || walter)) return gains;
    if (f.ndf == ND_NDF_IS_ggx && walter) return gains;
    bool wide = p->alpha_x > 1.0f || p->alpha_y > 1.0f;
    if (f.masking == ND_MASKING_IS_neumann && wide) return gains;
    return ND_CLAIM_ALL;
}

static bool bind_lobe(nd_lobe *l, nd_arena *a, ndl_error *error) {
    nd_binding b;
    const nd_schema *schema = l->model->schema();
    l->fields = nd_arena_alloc(a, schema->size);
    if (!l->fields) return out_of_memory(error);
    if (!nd_bind(&b, schema, &l->call, l->fields, a, error)) return false;
    if (l->model->ndf == ND_NO_FACET) {
        int at = combination(&b);
        l->kernel = l->model->kernels[at];
        l->traits = l->model->traits[at];
    } else {
        l->facet.ndf = l->model->ndf == ND_ANY_NDF ? nd_choice(&b, "ndf") : l->model->ndf;
        l->facet.masking = nd_choice(&b, "masking");
        l->facet.fresnel = nd_choice(&b, "fresnel");
        l->traits = facet_claims(l->facet, l->fields);
    }
    return true;
}

static bool find_model(nd_lobe *l, ndl_error *error) {
    char quoted[48];
    l->model = nd_model_find(l->call.name);
    if (l->model) return true;
    nd_quote(l->call.name, strlen(l->call.name), quoted, sizeof quoted);
    nd_nearest near = {l->call.name, NULL, 0};
    for (size_t i = 0; i < nd_model_count(); i++) nd_nearest_offer(&near, nd_model_at(i)->name);
    if (near.best)
        return nd_fail(error, NDL_E_UNKNOWN_NAME, l->call.column, "unknown model '", quoted,
                       "'; did you mean '", near.best, "'?", NULL);
    return nd_fail(error, NDL_E_UNKNOWN_NAME, l->call.column, "unknown model '", quoted,
                   "'; `ndotl models` lists them", NULL);
}

static void weigh(nd_lobe *l) {
    bool grey = l->call.weight.kind == ND_NUMBER;
    for (int i = 0; i < 3; i++)
        l->weight[i] = l->call.weighted ? l->call.weight.v[grey ? 0 : i] : 1.0f;
}

/* ---- whole materials ------------------------------------------------------------------------- */

ndl_material *nd_material_new(size_t lobes, ndl_error *error) {
    ndl_material *m = calloc(1, sizeof *m);
    if (m) m->lobes = nd_arena_alloc(&m->arena, lobes * sizeof *m->lobes);
    if (m && m->lobes) {
        m->count = lobes;
        return m;
    }
    free(m);
    out_of_memory(error);
    return NULL;
}

ndl_material *nd_material_finish(ndl_material *m, ndl_error *error) {
    for (size_t i = 0; i < m->count; i++) {
        weigh(&m->lobes[i]);
        if (!find_model(&m->lobes[i], error) || !bind_lobe(&m->lobes[i], &m->arena, error)) {
            ndl_material_free(m);
            return NULL;
        }
    }
    nd_share_draws(m);
    m->text = nd_print_text(m);
    m->json = nd_print_json(m);
    if (m->text && m->json) return m;
    ndl_material_free(m);
    out_of_memory(error);
    return NULL;
}

ndl_material *ndl_material_parse(const char *text, ndl_error *error) {
    if (error) *error = (ndl_error){0};
    ndl_material *m = nd_material_new(1, error);
    if (!m) return NULL;
    nd_expr e;
    if (!nd_expr_parse(text ? text : "", &m->arena, &e, error)) {
        ndl_material_free(m);
        return NULL;
    }
    m->lobes = nd_arena_alloc(&m->arena, (size_t)e.count * sizeof *m->lobes);
    if (!m->lobes) {
        ndl_material_free(m);
        out_of_memory(error);
        return NULL;
    }
    m->count = (size_t)e.count;
    for (int i = 0; i < e.count; i++) m->lobes[i].call = e.calls[i];
    return nd_material_finish(m, error);
}

void ndl_material_free(ndl_material *m) {
    if (!m) return;
    nd_arena_free(&m->arena);
    free(m->text);
    free(m->json);
    free(m);
}

const char *ndl_material_text(const ndl_material *m) {
    return m->text;
}

const char *ndl_material_json(const ndl_material *m) {
    return m->json;
}

size_t ndl_material_lobes(const ndl_material *m) {
    return m->count;
}

const char *ndl_material_model(const ndl_material *m, size_t i) {
    return i < m->count ? m->lobes[i].model->name : NULL;
}

unsigned ndl_material_claims(const ndl_material *m) {
    unsigned claims = ND_CLAIM_ALL;
    for (size_t i = 0; i < m->count; i++) claims &= m->lobes[i].traits;
    /* Lobes that each keep the energy keep it in a sum whose weights add up to 1 at most. */
    for (int c = 0; c < 3; c++) {
        double sum = 0.0;
        for (size_t i = 0; i < m->count; i++) sum += (double)m->lobes[i].weight[c];
        if (sum > 1.0 + 1e-6) claims &= ~(unsigned)NDL_CLAIM_ENERGY;
    }
    return claims;
}
