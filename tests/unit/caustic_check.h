/* Photon maps of small scenes given as text, and what lands where on a floor y = constant. */
#ifndef TESTS_UNIT_CAUSTIC_CHECK_H
#define TESTS_UNIT_CAUSTIC_CHECK_H

#include <math.h>
#include <stdlib.h>
#include <unistd.h>

#include "base/arena.h"
#include "parser/reader.h"
#include "photon/trace.h"
#include "tests/unit/check.h"

/* Reads, traces, and checks that flux is conserved. NULL on errors, counted as failures. */
static PhotonMap *caustic_trace(const char *text)
{
	char path[] = "caustic_XXXXXX";
	int file = mkstemp(path);
	CHECK(file >= 0 && write(file, text, strlen(text)) == (ssize_t)strlen(text));
	close(file);
	Diag *diag = diag_create(stdout);
	diag_set_warnings(diag, false);
	SceneBuilder builder = {
		.arena = arena_create(), .diag = diag, .settings = settings_default()};
	builder.camera = camera_default(1);
	ReaderOptions options = {.path = path, .image_width = 160, .image_height = 120};
	Scene *scene = reader_read(&options, &builder, diag) ? scene_freeze(&builder) : NULL;
	unlink(path);
	CHECK(scene != NULL);
	PhotonMap *map = NULL;
	if (scene) {
		PhotonStatistics s;
		map = photon_trace(scene, &(PhotonTraceOptions){.seed = 1, .scale = 1}, &s);
		CHECK(map && map->count > 0);
		double sum = s.stored_flux + s.absorbed_flux + s.escaped_flux;
		CHECK_NEAR(sum, s.emitted_flux, 1e-3 * s.emitted_flux);
	}
	scene_destroy(scene);
	arena_destroy(builder.arena);
	diag_destroy(diag);
	return map;
}

/* A frame on the floor: a along `along`, b to its left, seen from above with z to the left of
 * x. */
typedef struct FloorFrame {
	double x, z, along_x, along_z;
} FloorFrame;

static inline void floor_coordinates(const FloorFrame *frame, const Photon *photon, double *a,
				     double *b)
{
	double x = photon->position[0] - frame->x, z = photon->position[2] - frame->z;
	*a = x * frame->along_x + z * frame->along_z;
	*b = z * frame->along_x - x * frame->along_z;
}

/* Flux (grey) in the rectangle |a - middle| < half_a, |b| < half_b, and how many photons that
 * is. */
static inline double floor_flux(const PhotonMap *map, const FloorFrame *frame,
                         const double rectangle[3], int *count)
{
	double sum = 0;
	*count = 0;
	for (uint32_t i = 0; i < map->count; i++) {
		double a, b;
		floor_coordinates(frame, &map->photons[i], &a, &b);
		if (fabs(a - rectangle[0]) < rectangle[1] && fabs(b) < rectangle[2]) {
			sum += rgb_gray(photon_flux(&map->photons[i]));
			(*count)++;
		}
	}
	return sum;
}

#endif
