/*
 * Focal blur: rays through points of the aperture and of the pixel until the mean is known as well
 * as the camera asks (confidence and variance), at most blur_samples of them. The points are
 * Halton's, shifted for each pixel by a random amount.
 */
#include "render/sample.h"

#include <math.h>

/* Sums over the rays of a bundle. */
typedef struct Bundle {
	double sum[4], square[4];
	int count;
} Bundle;

/* The normal quantile for a two-sided confidence: Abramowitz & Stegun 26.2.23, |error| < 4.5e-4. */
static double confidence_width(double confidence)
{
	double tail = fmin(fmax((1 - confidence) / 2, 1e-9), 0.5);
	double t = sqrt(-2 * log(tail));
	return t - (2.515517 + t * (0.802853 + t * 0.010328)) /
			   (1 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
}

/* variance: what that of the mean may be; it must be below: with 0 all samples are taken. */
static bool bundle_is_sure(const Bundle *bundle, double variance)
{
	double n = bundle->count, most = variance * n * (n - 1);
	if (bundle->count < 2)
		return false;
	for (int i = 0; i < 4; i++)
		if (bundle->square[i] - bundle->sum[i] * bundle->sum[i] / n >= most)
			return false;
	return true;
}

static void bundle_add(Bundle *bundle, const float color[4])
{
	for (int i = 0; i < 4; i++) {
		/* Over-bright light must not ask for endless rays. */
		double shown = real_min(real_max(color[i], 0), 1);
		bundle->sum[i] += shown;
		bundle->square[i] += shown * shown;
	}
	bundle->count++;
}

static void set_rgb(float *out, Rgb color)
{
	out[0] = color.r;
	out[1] = color.g;
	out[2] = color.b;
}

/* out: a whole pixel's channels */
static void set_color(Tracer *tracer, Seen seen, float *out)
{
	set_rgb(out + film_layer_offset(FILM_CAUSTIC), seen.caustic);
	set_rgb(out + film_layer_offset(FILM_DIRECT), rgb_sub(seen.color, seen.caustic));
	set_rgb(out, seen.color);
	out[3] = tracer->alpha ? 1 - seen.transmit : 1;
}

static void set_first(const FirstHit *first, FilmPixel *out)
{
	set_rgb(out->v + film_layer_offset(FILM_ALBEDO), first->albedo);
	set_rgb(out->v + film_layer_offset(FILM_PHOTON_PARAMETER), first->parameter);
	out->v[film_layer_offset(FILM_PHOTON_COUNT)] = first->photons;
	out->v[film_layer_offset(FILM_PHOTON_EDGES)] = first->edges;
	out->v[film_layer_offset(FILM_PHOTON_CONSTRAINT)] = first->constraint;
	vec3_to_floats(first->normal, out->v + film_layer_offset(FILM_NORMAL));
	out->v[film_layer_offset(FILM_DEPTH)] = (float)first->depth;
}

static void eye_sample(Tracer *tracer, const SamplePlace *place, Vec2 lens, FilmPixel *out)
{
	const Camera *camera = &tracer->scene->camera;
	FirstHit first = {.depth = INFINITY};
	Ray ray;
	*out = (FilmPixel){{0}};
	if (camera_ray(camera, place->x, place->y, place->width, place->height, lens, &ray))
		set_color(tracer, trace_eye(tracer, &ray, place->first_hit ? &first : NULL),
			  out->v);
	else
		out->v[3] = tracer->alpha ? 0 : 1;
	if (place->first_hit)
		set_first(&first, out);
}

/* A mesh camera with several rays: the mean of those that have a face. */
static void mesh_sample(Tracer *tracer, const SamplePlace *place, FilmPixel *out)
{
	const MeshCamera *mesh = tracer->scene->camera.mesh;
	double sum[FILM_LIGHT_CHANNELS] = {0};
	int count = 0;
	eye_sample(tracer, place, (Vec2){0.5, 0.5}, out);
	for (int i = 0; i < mesh->rays; i++) {
		Ray ray;
		FilmPixel one = {{0}};
		if (!mesh_camera_ray(mesh, i, (Vec2){place->x, place->y},
				     (const int[]){place->width, place->height}, &ray))
			continue;
		set_color(tracer, trace_eye(tracer, &ray, NULL), one.v);
		for (int k = 0; k < FILM_LIGHT_CHANNELS; k++)
			sum[k] += one.v[k];
		count++;
	}
	for (int k = 0; k < FILM_LIGHT_CHANNELS && count > 0; k++)
		out->v[k] = (float)(sum[k] / count);
}

static double wrap(double x)
{
	return x - floor(x);
}

/* What POV-Ray's manual says for scenes that give none. */
static int least_samples(const Camera *camera)
{
	if (camera->blur_samples_min > 0)
		return camera->blur_samples_min;
	return camera->blur_samples < 7 ? 4 : 7;
}

static void blurred_sample(Tracer *tracer, const SamplePlace *place, FilmPixel *out)
{
	const Camera *camera = &tracer->scene->camera;
	enum { LENS_U, LENS_V, PIXEL_X, PIXEL_Y, DIMENSIONS };
	double shift[DIMENSIONS], u[DIMENSIONS];
	for (int k = 0; k < DIMENSIONS; k++)
		shift[k] = sampler_next(&tracer->sampler);
	double sum[FILM_LIGHT_CHANNELS] = {0};
	Bundle bundle = {.count = 0};
	int least = least_samples(camera);
	double width = confidence_width(camera->confidence),
	       variance = camera->variance / (width * width);
	for (int i = 0; i < camera->blur_samples; i++) {
		FilmPixel one;
		SamplePlace moved = *place;
		for (int k = 0; k < DIMENSIONS; k++)
			u[k] = wrap(random_halton((uint64_t)i, k) + shift[k]);
		moved.x += u[PIXEL_X] - 0.5;
		moved.y += u[PIXEL_Y] - 0.5;
		eye_sample(tracer, &moved, (Vec2){u[LENS_U], u[LENS_V]}, &one);
		if (i == 0)
			*out = one;
		bundle_add(&bundle, one.v);
		for (int k = 0; k < FILM_LIGHT_CHANNELS; k++)
			sum[k] += one.v[k];
		if (bundle.count >= least && bundle_is_sure(&bundle, variance))
			break;
	}
	for (int k = 0; k < FILM_LIGHT_CHANNELS; k++)
		out->v[k] = (float)(sum[k] / bundle.count);
}

void sample_image(Tracer *tracer, const SamplePlace *place, FilmPixel *out)
{
	const Camera *camera = &tracer->scene->camera;
	tracer->sampler.index = place->number;
	tracer->sampler.dimension = 0;
	tracer->statistics.samples++;
	if (camera->aperture > 0 && camera->blur_samples > 1)
		blurred_sample(tracer, place, out);
	else if (camera->kind == CAMERA_MESH && camera->mesh->rays > 1)
		mesh_sample(tracer, place, out);
	else
		eye_sample(tracer, place, (Vec2){0.5, 0.5}, out);
}
