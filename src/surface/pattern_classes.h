/* The pattern classes, for pattern.c's table: one line a pattern, family by family. Not for others.
 */
#ifndef SURFACE_PATTERN_CLASSES_H
#define SURFACE_PATTERN_CLASSES_H

#include "surface/pattern.h"

/* pattern_simple.c */
extern const PatternClass pattern_solid, pattern_gradient, pattern_planar, pattern_spherical,
	pattern_cylindrical, pattern_boxed, pattern_radial, pattern_onion, pattern_leopard,
	pattern_spiral1, pattern_spiral2, pattern_quilted;
/* pattern_noise.c */
extern const PatternClass pattern_bozo, pattern_bumps, pattern_spotted, pattern_dents,
	pattern_wrinkles, pattern_granite, pattern_agate, pattern_marble, pattern_wood;
/* pattern_wave.c */
extern const PatternClass pattern_ripples, pattern_waves;
/* pattern_block.c */
extern const PatternClass pattern_checker, pattern_brick, pattern_hexagon, pattern_cubic,
	pattern_square, pattern_triangular, pattern_object;
/* pattern_tiling.c */
extern const PatternClass pattern_tiling;
/* pattern_pavement.c */
extern const PatternClass pattern_pavement;
/* pattern_crackle.c */
extern const PatternClass pattern_cells, pattern_crackle, pattern_facets;
/* pattern_fractal.c */
extern const PatternClass pattern_mandel, pattern_julia, pattern_magnet1m, pattern_magnet1j,
	pattern_magnet2m, pattern_magnet2j;
/* pattern_data.c */
extern const PatternClass pattern_function, pattern_image, pattern_density_file, pattern_pigment,
	pattern_slope, pattern_aoi, pattern_potential;

/* The sine of a whole turn per unit. */
double pattern_cycloid(double value);
/* Up from 0 to 1 and down again per unit. */
double pattern_triangle_wave(double value);
/* The noise generator to use: the pattern's or the default. */
int pattern_generator(const Pattern *pattern);

#endif
