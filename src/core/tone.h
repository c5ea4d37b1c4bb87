/* SPDX-License-Identifier: Apache-2.0 */
/* The sRGB transfer functions. */
#ifndef ND_CORE_TONE_H
#define ND_CORE_TONE_H

/* Linear value of an sRGB-encoded one, 1. Domain: [0, 1]. Source: IEC 61966-2-1. */
float nd_srgb_decode(float encoded);

/* sRGB encoding of a linear value, 1. Domain: [0, 1]. Source: IEC 61966-2-1. */
float nd_srgb_encode(float linear);

#endif
