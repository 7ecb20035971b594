/*
 * Layers of OpenEXR pictures: by name, and drawn so that people can look at them. A layer is a set
 * of channels whose names start alike, "caustic.R" being one of the layer caustic; RGBA is the
 * layer of those whose names have no start.
 */
#ifndef IMAGE_LAYER_H
#define IMAGE_LAYER_H

#include "base/arena.h"
#include "image/exr.h"
#include "image/image.h"

/* The layer's first three channels in the order R, G, B or X, Y, Z, or the only one it has, linear.
 * NULL when it is not there. */
Image *layer_extract(const ExrImage *exr, const char *layer);

/* Names of all layers, each once, in the file's order; returns how many. The arena owns them. */
int layer_names(const ExrImage *exr, const char ***names, Arena *arena);

/* The least and the largest finite value. False when there is none. */
bool layer_bounds(const Image *layer, double *least, double *most);

typedef struct LayerView {
	double least, most; /* of the scale of a layer of numbers; equal: the layer's own bounds */
	double exposure;    /* factor of colours and of the light that shades layers of photons */
	bool unlit;         /* layers of photons are not shaded by the caustic's light */
} LayerView;

/*
 * The layer as colours from 0 to 1 that a screen shows, four channels, to be written with no
 * further transfer. Colours of light get sRGB's; N is moved from -1..1; numbers become false
 * colours between least and most. Layers of photons are shaded by the layer caustic where the file
 * has it: photons.parameter's colours spread over what the picture holds, photons.count and
 * photons.edges in false colours, photons.constraint by reddening grey light. NULL when the layer
 * is not there.
 */
Image *layer_draw(const ExrImage *exr, const char *layer, const LayerView *view);

#endif
