/*
 * How a surface scatters light: the one place where a finish becomes numbers, for eye rays and for
 * photons alike.
 *
 * A bsdf is one stack of texture layers seen from one direction. It has smooth lobes (diffuse, with
 * iridescence, and highlights), which bsdf_eval gives, and at most one mirror per layer and one
 * passage through, which bsdf_events lists. Values follow POV-Ray: a white diffuse 1 surface lit
 * head on by a light of colour 1 shows colour 1; in physical terms eval is pi * f_r * cos.
 *
 * Directions are unit and in world space. `from` is where the path comes from, seen from the
 * surface (against the ray), `to` where it goes on. For an eye path light flows to -> from, for a
 * photon from -> to; the transport says which, since a refraction changes radiance but not flux and
 * POV-Ray's lobes are not all symmetric.
 */
#ifndef SURFACE_BSDF_H
#define SURFACE_BSDF_H

#include "surface/texture.h"

typedef enum Transport { TRANSPORT_RADIANCE, TRANSPORT_FLUX } Transport;

enum { BSDF_MAX_LAYERS = 24, BSDF_MAX_EVENTS = BSDF_MAX_LAYERS + 1 };

/* One layer, with what the layers above let through worked in. */
typedef struct BsdfLayer {
	const Finish *finish;
	Vec3 normal;       /* perturbed, on from's side */
	Rgb color;         /* the pigment's */
	Rgb above;         /* what the layers above let through */
	float opacity;     /* 1 - filter - transmit of this layer */
	Rgb mirror;        /* reflectance for from */
	float grain;       /* darkening by crand */
	float film;        /* irid: the film's thickness at this place */
} BsdfLayer;

typedef struct Bsdf {
	BsdfLayer layers[BSDF_MAX_LAYERS]; /* top to bottom */
	int count;
	Vec3 from;
	Vec3 geometric;    /* unperturbed unit normal on from's side */
	double ior;        /* index of the side it came from over that of the other side */
	Rgb through;       /* what the whole stack lets through */
	bool both_sides;   /* double_illuminate */
	Rgb irid_wavelength;
} Bsdf;

/* What bsdf_init wants to know of a stack. */
typedef struct BsdfPlace {
	Vec3 from, geometric;
	double ior;
	double mirror_ior; /* the one that Fresnel's share of a mirror goes by: the same, but for
			      POV-Ray's views of nested objects */
	bool both_sides;
	bool legacy; /* a scene before version 3.7: a filter leaves more of the surface's own light
		      */
	Rgb irid_wavelength;
	Vec3 world;        /* the place: where irid's turbulence is taken */
	double grain;      /* a random number in [0, 1) for crand */
	double cutoff;     /* layers under one that lets less than this through are left out */
} BsdfPlace;

void bsdf_init(Bsdf *bsdf, const ShadingLayer *bottom_to_top, int count, const BsdfPlace *place);

/* Light that shines by itself: ambient (by the scene's ambient light) and emission. */
Rgb bsdf_emission(const Bsdf *bsdf, Rgb ambient_light);

/* The smooth lobes; highlights off leaves phong and specular out (fill lights). */
Rgb bsdf_eval(const Bsdf *bsdf, Vec3 to, bool highlights);
/* True when eval is black for every direction. */
bool bsdf_is_delta(const Bsdf *bsdf);
static inline bool bsdf_finish_is_delta(const Finish *finish)
{
	return finish->diffuse == 0 && finish->diffuse_back == 0 && finish->phong <= 0 &&
	       finish->specular <= 0;
}
/* True when light from the back side (to below the surface) can count. */
bool bsdf_sees_back(const Bsdf *bsdf);

/* The probability density per solid angle with which bsdf_sample picks `to` as a smooth direction.
 */
double bsdf_pdf(const Bsdf *bsdf, Vec3 to);

typedef enum BsdfEventKind { BSDF_SMOOTH, BSDF_REFLECT, BSDF_TRANSMIT } BsdfEventKind;

typedef struct BsdfEvent {
	BsdfEventKind kind;
	Vec3 to;
	Rgb weight; /* what the light is multiplied with; of a sample: already divided by its
		       probability */
	float exponent;   /* reflection's exponent: raise the colour seen to its inverse first */
	bool bent;        /* transmission changed direction, or turned into total reflection */
	bool total;       /* a transmission that was totally reflected: it stays on from's side */
} BsdfEvent;

/* The mirrors and the passage through whose weight is not black; returns how many. */
int bsdf_events(const Bsdf *bsdf, Transport transport, BsdfEvent out[BSDF_MAX_EVENTS]);
/* One way to go on, chosen by u[0] among lobes and events by their weight; u[1], u[2] place a
 * smooth direction. False: the path ends (absorbed). The expectation of weight is the surface's
 * albedo. */
bool bsdf_sample(const Bsdf *bsdf, const double u[3], Transport transport, BsdfEvent *out);

/* What metallic tints a mirror or highlight with at a cosine. */
Rgb bsdf_metal_tint(Rgb color, double metallic, double cosine);
/* Fresnel's reflectance for unpolarised light; ior: index of the side the light comes from over the
 * other's. */
double bsdf_fresnel(double cosine, double ior);
/* The refracted direction for a ray along direction hitting a surface with normal against it;
 * false: total reflection. */
bool bsdf_refract(Vec3 direction, Vec3 normal, double ior, Vec3 *out);

#endif
