/* SPDX-License-Identifier: Apache-2.0 */
#ifndef ND_IO_JSON_MATERIAL_H
#define ND_IO_JSON_MATERIAL_H
#include "ndotl/ndotl.h"

/* Makes a material from its JSON long form, as ndl_material_json writes it:
       {"lobes":[{"weight":[r,g,b],"model":"ggx","params":{"alpha":0.3,"preset":"gold"}}]}
   weight and params may be missing; colours are numbers, arrays of three or "#rrggbb", ramps are
   [[x, color], ...]. JSON numbers are read as double and then rounded to float.
   Errors:   NULL and those of ndl_material_parse. Where JSON itself is broken the column is that of
             the text; otherwise it is 0 and the text begins with the place, as in
             "lobes[0].params.rough: ...". */
ndl_material *nd_json_material(const char *text, ndl_error *error);

#endif
