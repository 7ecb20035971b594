/*
 * What scenes say about photons: POV-Ray's own words and the extension's. Plain data; lang fills it
 * in, the photon rooms read it.
 */
#ifndef SCENE_PHOTON_SETTINGS_H
#define SCENE_PHOTON_SETTINGS_H

#include <stdbool.h>

#include "base/diag.h"

typedef enum EstimatorKind {
	ESTIMATOR_NEAREST,
	ESTIMATOR_DIFFUSION,
	ESTIMATOR_FOOTPRINT,
	ESTIMATOR_DEEP,
	ESTIMATOR_ADAPTIVE
} EstimatorKind;

typedef enum EstimatorKernel {
	KERNEL_UNIFORM, KERNEL_CONE, KERNEL_EPANECHNIKOV, KERNEL_GAUSSIAN, KERNEL_ISOTROPIC
} EstimatorKernel;

/* estimator { }: zeros stand for the method's own default. */
/* No method gathers more photons at a point: they stand on the stack. */
enum { ESTIMATOR_MOST_PHOTONS = 10000 };

typedef struct Estimator {
	EstimatorKind kind;
	EstimatorKernel kernel;
	int count;           /* nearest, diffusion: photons */
	double radius;       /* nearest: scene units */
	double diffusivity;  /* diffusion */
	double scale;        /* footprint */
	const char *network; /* deep, adaptive: a name or a path */
	int grid, updates;   /* adaptive */
	Location where;      /* it was asked for, in a scene */
} Estimator;

typedef struct Relaxation {
	bool on, constrained;
	int parameter_iterations, world_iterations;
	int neighbors, repulsion_neighbors;
	double range;
	bool gradient; /* constrained: what the density's own gradient pushes is taken off */
	bool hues;     /* constrained: parted light is told apart by hue */
} Relaxation;

typedef enum Reduction {
	REDUCTION_APA,
	REDUCTION_PPM,
	REDUCTION_APPM,
	REDUCTION_CPPM,
	REDUCTION_SCHEDULE
} Reduction;

enum { PROGRESSIVE_MOST_PASSES = 1000000000 };

typedef struct Progressive {
	bool on;
	int passes;     /* 0: as many as the time allows */
	double seconds; /* 0: no limit */
	double radius;  /* 0: from the photons' spacing */
	Reduction reduction;
} Progressive;

enum { PHOTON_RADII = 2 };

/* global_settings { photons { } } */
typedef struct PhotonSettings {
	bool on;
	Location where;             /* how many were asked for */
	double spacing;             /* 0: unset */
	double count;               /* of paths, whole; 0: unset */
	int gather_min, gather_max; /* 20, 100 */
	/* Surface and media: first radius, its factor, then the same for gathering. 0: unset. */
	struct { double radius, factor, gather_radius, gather_factor; } radii[PHOTON_RADII];
	double jitter;              /* 0: paths start without a grid */
	double autostop;            /* 1: never */
	int max_trace_level;        /* 0: the scene's */
	double adc_bailout;         /* -1: the scene's */
	double expand_increase;     /* 0.2 */
	int expand_min;             /* 40 */
	int media_steps;            /* 0: none in media */
	double media_factor;        /* 1 */
	const char *save_file, *load_file;
	bool emitter_coordinates;   /* true */
	Relaxation relaxation;
	Estimator estimator;
	Progressive progressive;
} PhotonSettings;

PhotonSettings photon_settings_default(void);
/* An estimator's settings when only its word is said; "povray" stands for saying nothing. False for
 * other names. */
bool photon_estimator_named(const char *name, Estimator *out);
/* Relaxation under constraints, and plain, when only the word is said. */
Relaxation relaxation_default(void);
Relaxation relaxation_plain(void);

#endif
