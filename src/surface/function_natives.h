/* Functions made of what scenes name otherwise: patterns, pigments, transformations, and POV-Ray's
 * internal functions. */
#ifndef SURFACE_FUNCTION_NATIVES_H
#define SURFACE_FUNCTION_NATIVES_H

#include "base/transform.h"
#include "surface/function.h"
#include "surface/texture.h"

/* x, y, z to the pattern's value. The pattern must outlive the function. */
const Function *function_of_pattern(Arena *arena, const Pattern *pattern);
/* x, y, z to the pigment's colour. */
const VectorFunction *function_of_pigment(Arena *arena, const Pigment *pigment);
/* The grey value of a colour: of a vector function's result taken as one. */
const Function *function_of_gray(Arena *arena, const VectorFunction *vector);
/* x, y, z to the transformed point. */
const VectorFunction *function_of_transform(Arena *arena, const Transform *transform);
/* The internal function of that number (functions.inc names them); NULL when there is none.
 * noise_generator is the one that f_noise3d uses. */
const Function *function_internal_find(Arena *arena, int number, int noise_generator);

#endif
