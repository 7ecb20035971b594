/* The colours that patterns have where the scene gives none: POV-Ray's. */
#ifndef LANG_BUILD_PIGMENT_DEFAULT_H
#define LANG_BUILD_PIGMENT_DEFAULT_H

#include "surface/texture.h"

/* Gives the pigment the colour map of its pattern. */
void build_default_map(Pigment *pigment);
/* Entry i of a list pattern. */
Rgbft build_default_list_color(const Pattern *pattern, int i);

#endif
