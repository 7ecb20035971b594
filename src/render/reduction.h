/* How the radius of progressive photon mapping shrinks from pass to pass. One method a file, a row
 * in the table. */
#ifndef RENDER_REDUCTION_H
#define RENDER_REDUCTION_H

#include <stdint.h>

#include "scene/photon_settings.h"

typedef struct ReductionMethod {
	const char *name;
	/* The radius of a pass, counted from 0, from the first pass' radius. */
	double (*radius)(double first, uint32_t pass);
} ReductionMethod;

/* NULL: not available. */
const ReductionMethod *reduction_find(Reduction reduction);

extern const ReductionMethod reduction_apa; /* reduction_apa.c */

#endif
