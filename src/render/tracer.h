/*
 * Following one ray of light backwards from the eye. A Tracer is one thread's worker: the constant
 * scene, and scratch that nobody else touches. Everything a ray does depends on the scene, the
 * options and the sampler's seed and index alone.
 */
#ifndef RENDER_TRACER_H
#define RENDER_TRACER_H

#include "base/random.h"
#include "scene/inside.h"
#include "render/render.h"
#include "scene/accel.h"
#include "scene/scene.h"
#include "surface/bsdf.h"

/* What +Q leaves of the picture (manual 3.2.8.3). */
typedef struct Quality {
	bool lights;      /* 2: else full ambient */
	bool shadows;     /* 4 */
	bool area_lights; /* 5 */
	bool scatter;     /* 8: reflected, refracted, transmitted rays */
	bool atmosphere;  /* 9, and there is some: fog and rainbow go with media */
} Quality;

typedef struct Tracer {
	const Scene *scene;
	Quality quality;
	bool legacy;             /* a scene before version 3.7 */
	const Caustics *caustics; /* or NULL */
	Rgb ambient_light;
	bool alpha;              /* keep the background transparent */
	const Shape **blockers; /* per light: what shadowed the last point; a hint, no result
				   depends on it */
	Rgb *grid;               /* visibility of the points of the largest area light */
	bool *grid_known;
	InsideStack eye;         /* what the camera is in */
	Vec3 eye_place;          /* where that was found out */
	double sample_width, sample_spread; /* of a sample's share of the picture, at the eye and
					       per distance from it */
	Vec3 sample_across;      /* the picture's horizontal, of any length */
	Sampler sampler;         /* set for each sample of a pixel */
	RenderStatistics statistics;
} Tracer;

typedef struct PathRay {
	Ray ray;                 /* unit direction */
	double weight;           /* share that its light will have in the pixel */
	int level;               /* reflections and refractions so far */
	int depth;               /* crossings of any kind so far */
	bool reflected;          /* for no_image and no_reflection */
	double distance;         /* from the eye to the ray's start, along the path */
	double hue;              /* 0 red .. 1 violet, once dispersion has parted the light */
	bool colored;            /* it has; else hue is 0.5 */
	InsideStack inside;
} PathRay;

/* What a ray sees: light, and the share of it that is the untouched background showing through
 * (alpha). */
typedef struct Seen {
	Rgb color;
	Rgb caustic;             /* the part of color that photons brought */
	float transmit;
} Seen;

/* What the eye ray met first. */
typedef struct FirstHit {
	double depth;
	Vec3 normal;
	Rgb albedo;
	float photons;           /* that were gathered */
	Rgb parameter;           /* their mean emitter coordinates as a colour */
	float edges;             /* their mean number of path edges */
	float constraint;        /* how much relaxation held them, in [0, 1] */
} FirstHit;

void tracer_init(Tracer *tracer, const Scene *scene, const RenderOptions *options);
void tracer_free(Tracer *tracer);

/* first: where to put the first hit, or NULL. */
Seen trace_ray(Tracer *tracer, const PathRay *path, FirstHit *first);
/* Starts at the camera: finds out what the ray begins in. */
Seen trace_eye(Tracer *tracer, const Ray *ray, FirstHit *first);

#endif
