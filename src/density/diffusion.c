/*
 * Diffusion based photon mapping (Schjøth, Sporring & Fogh Olsen 2008): the kernel takes the shape
 * of the structure around the gather point, narrow across an edge of the illumination and wide
 * along it.
 *
 * Prepared for every photon: the gradient of the density estimate there (Epanechnikov, from a
 * fifth of the estimator's count), in the photon's tangent plane, relative to the density and to
 * the radius of its estimate, so that it has no unit: 0 where density is constant, 16 / 3 pi at a
 * straight edge.
 *
 * At a gather point: the structure tensor S is the Gaussian-weighted mean of gradient (x) gradient
 * over the photons found. The diffusion tensor D has its eigenvectors, and eigenvalues 1 / (1 + s
 * / d^2) for its eigenvalues s (Perona & Malik 1990; d: the diffusivity, 0.5 unless given: less
 * keeps weaker edges). The estimate is the sum of flux times K(x . D^-1 x / r^2) / (r^2 sqrt(det
 * D)) with the Gaussian disc kernel, which has integral one for every D, and lies inside the disc
 * of the photons found.
 *
 * What differs from the paper: the gradient is relative, so that one diffusivity serves bright and
 * dim caustics alike and scenes of any size; what the photons' noise adds to S, 4 / k for k
 * photons, is taken off before, so that kernels stay round where light is even; the kernel ends at
 * the disc, and is no narrower than a pixel.
 */
#include <math.h>

#include "base/arena.h"
#include "base/parallel.h"
#include "density/gather.h"
#include "density/kernel.h"

typedef struct Gradient { float at[3]; } Gradient;

typedef struct Diffusion {
	const PhotonMap *map;
	int count, gradient_count;
	double reach, gradient_reach, contrast2, noise;
	Gradient gradients[]; /* one a photon */
} Diffusion;

enum { DEFAULT_COUNT = 500, GRADIENT_SHARE = 5, LEAST_GRADIENT_COUNT = 10 };
static const double default_diffusivity = 0.5;
/* A kernel is at most ten times as long as wide: narrower ones hold single photons. */
static const double least_eigenvalue = 0.01;

/* ---- gradients ---- */

static void set_gradient(void *data, long item, int thread)
{
	(void)thread;
	Diffusion *d = data;
	const Photon *center = &d->map->photons[item];
	GatherPoint point = {.position = vec3_of_floats(center->position),
			     .normal = photon_normal(center)};
	GatherTask task = {.map = d->map, .point = &point};
	Neighbor found[GATHER_ROOM(d->gradient_count)];
	double radius2, density = 0;
	Vec3 sum = vec3(0, 0, 0);
	int count = gather_nearest(&task, d->gradient_count, d->gradient_reach, found, &radius2);
	for (int i = 0; i < count && radius2 > 0; i++) {
		const Photon *photon = &d->map->photons[found[i].index];
		double flux = rgb_gray(photon_flux(photon));
		sum = vec3_mad(sum, 2 * flux / sqrt(radius2),
			       vec3_sub(vec3_of_floats(photon->position), point.position));
		density += flux * (1 - found[i].distance2 / radius2);
	}
	sum = vec3_mad(sum, -vec3_dot(sum, point.normal), point.normal);
	if (density > 0)
		sum = vec3_scale(sum, 1 / density);
	d->gradients[item] = (Gradient){{(float)sum.x, (float)sum.y, (float)sum.z}};
}

static void *diffusion_create(const EstimatorSetup *setup, Diag *diag)
{
	(void)diag;
	const Estimator *e = setup->method;
	Diffusion *d = memory_alloc(sizeof *d + sizeof(Gradient) * setup->map->count);
	*d = (Diffusion){.map = setup->map, .count = e->count > 0 ? e->count : DEFAULT_COUNT};
	int share = d->count / GRADIENT_SHARE;
	d->gradient_count = share > LEAST_GRADIENT_COUNT ? share : LEAST_GRADIENT_COUNT;
	d->reach = setup->radius > 0 ? setup->radius : gather_reach(setup->map, d->count);
	d->gradient_reach = gather_reach(setup->map, d->gradient_count);
	double diffusivity = e->diffusivity > 0 ? e->diffusivity : default_diffusivity;
	d->contrast2 = diffusivity * diffusivity;
	d->noise = 4.0 / d->gradient_count;
	parallel_for(setup->map->count, 256, set_gradient, d);
	return d;
}

/* ---- tensors ---- */

/* A symmetric tensor in the plane of the tangents u and v. */
typedef struct Tensor { double uu, uv, vv; } Tensor;

typedef struct Frame { Vec3 origin, u, v; } Frame;

static Tensor structure_tensor(const Diffusion *d, const Frame *frame, const Neighbor *found,
                               int count, double radius2)
{
	Tensor s = {0, 0, 0};
	double total = 0;
	for (int i = 0; i < count; i++) {
		Vec3 gradient = vec3_of_floats(d->gradients[found[i].index].at);
		double weight = kernel_value(KERNEL_GAUSSIAN, found[i].distance2 / radius2);
		double u = vec3_dot(gradient, frame->u), v = vec3_dot(gradient, frame->v);
		s = (Tensor){s.uu + weight * u * u, s.uv + weight * u * v, s.vv + weight * v * v};
		total += weight;
	}
	double scale = total > 0 ? 1 / total : 0;
	return (Tensor){scale * s.uu, scale * s.uv, scale * s.vv};
}

static double diffusion_of(const Diffusion *d, double eigenvalue, double least)
{
	double edge = fmax(0, eigenvalue - d->noise);
	return fmax(least, 1 / (1 + edge / d->contrast2));
}

/* The inverse of the diffusion tensor, and the square root of its determinant. */
static Tensor inverse_diffusion(const Diffusion *d, Tensor s, double least, double *root)
{
	double mean = 0.5 * (s.uu + s.vv), difference = 0.5 * (s.uu - s.vv);
	double spread = sqrt(difference * difference + s.uv * s.uv);
	double across = 1 / diffusion_of(d, mean + spread, least),
	       along = 1 / diffusion_of(d, mean - spread, least);
	/* S = mean I + spread R, with R of eigenvalues 1 and -1: so is any function of S. */
	double middle = 0.5 * (across + along),
	       half = spread > 0 ? 0.5 * (across - along) / spread : 0;
	*root = 1 / sqrt(across * along);
	return (Tensor){middle + half * difference, half * s.uv, middle - half * difference};
}

static void diffusion_gather(const void *method, const GatherTask *task, GatherResult *result)
{
	const Diffusion *d = method;
	Neighbor found[GATHER_ROOM(d->count)];
	GatherSum sum = {.task = task};
	Frame frame = {.origin = task->point->position};
	Window pixel = window_around(task->point, 0);
	double radius2, root = 1, pixel2 = gather_least_radius2(&pixel);
	int count = gather_nearest(task, d->count, d->reach, found, &radius2);
	if (radius2 < pixel2) {
		gather_pixel(task, &pixel, result);
		return;
	}
	vec3_frame(task->point->normal, &frame.u, &frame.v);
	if (!(radius2 > 0))
		count = 0;
	double least = radius2 > 0 ? fmax(least_eigenvalue, pixel2 / radius2) : 1;
	Tensor inverse = inverse_diffusion(d, structure_tensor(d, &frame, found, count, radius2),
					   least, &root);
	for (int i = 0; i < count; i++) {
		const Photon *photon = &task->map->photons[found[i].index];
		Vec3 offset = vec3_sub(vec3_of_floats(photon->position), frame.origin);
		double u = vec3_dot(offset, frame.u), v = vec3_dot(offset, frame.v);
		double t2 = (inverse.uu * u * u + 2 * inverse.uv * u * v + inverse.vv * v * v) /
			    radius2;
		gather_add(&sum, photon, kernel_value(KERNEL_GAUSSIAN, t2) / (radius2 * root));
	}
	gather_finish(&sum, sqrt(radius2), result);
}

const EstimatorMethod diffusion_method = {"diffusion", diffusion_create, diffusion_gather};
