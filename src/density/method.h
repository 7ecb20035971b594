/* What an estimator's file gives to the table in estimator.c. */
#ifndef DENSITY_METHOD_H
#define DENSITY_METHOD_H

#include "density/estimator.h"

/* What a gather needs beside the method's own data. */
typedef struct GatherTask {
	const PhotonMap *map;
	const GatherPoint *point;
	GatherBsdf *bsdf;
	void *data; /* bsdf's */
} GatherTask;

typedef struct EstimatorMethod {
	const char *name; /* as in the scene */
	/* The method's own data, one block for free(); NULL on failure, reported, or when
	 * stopped. */
	void *(*create)(const EstimatorSetup *setup, Diag *diag);
	/* result comes zeroed. */
	void (*gather)(const void *method, const GatherTask *task, GatherResult *result);
} EstimatorMethod;

extern const EstimatorMethod nearest_method;   /* nearest.c: k nearest, or a fixed radius */
extern const EstimatorMethod diffusion_method; /* diffusion.c */
extern const EstimatorMethod expand_method;    /* expand.c: as POV-Ray gathers */
extern const EstimatorMethod footprint_method; /* footprint.c: sheets over emitter space */

#endif
