/* One sample of the image: the eye ray, or the bundle of them that focal blur needs. */
#ifndef RENDER_SAMPLE_H
#define RENDER_SAMPLE_H

#include "render/tracer.h"

/* What is a sample's number within its pixel; makes its random numbers its own. */
typedef struct SamplePlace {
	double x, y;     /* in pixels; 0,0 is the upper left corner of the image */
	uint64_t number; /* unique in the image */
	int width, height;
	bool first_hit;  /* the film wants to know what was met */
} SamplePlace;

/* All layers of what is seen there. Sets the tracer's sampler. */
void sample_image(Tracer *tracer, const SamplePlace *place, FilmPixel *out);

#endif
