/*
 * The photon: 48 bytes. It remembers where it left its light (Spencer & Jones 2013, section 4.1):
 * emitter coordinates are the 2-D origin on the emitter's plane (third 0) for collimated lights, or
 * the unit exit direction for point-like ones.
 */
#ifndef PHOTON_PHOTON_H
#define PHOTON_PHOTON_H

#include <stdint.h>

#include "base/color.h"
#include "base/vec.h"

typedef struct Photon {
	float position[3];     /* world */
	float emitter[3]; /* emitter coordinates, in the light's own units: see light/emission.h */
	float length;          /* of the path from the light, scene units */
	uint16_t mantissa[3];  /* flux: mantissa * 2^(exponent - 16) per channel */
	uint16_t path; /* hash of the objects, flat faces and events on the way: equal for photons
			  of one sheet */
	uint16_t direction[2]; /* where it came from: unit vector from the surface back along the
				  path, octahedral */
	uint16_t light;        /* number of the scene's light */
	uint16_t object;       /* Surface.id of the object it landed on, modulo 65536 */
	uint8_t normal[2];     /* of the surface it landed on, on the photon's side, octahedral */
	uint8_t edges;         /* of the path: 2 for light - glass - table */
	int8_t exponent;       /* flux's */
} Photon;

_Static_assert(sizeof(Photon) == 48, "a photon is 48 bytes");

/* flux: share of the light's radiant flux that this photon carries, such that a surface of albedo 1
 * which gathers flux F per area A shows the colour F / A, as POV-Ray's light of colour 1 shows 1
 * (irradiance divided by pi is not taken). */
void photon_set_flux(Photon *photon, Rgb flux);
Rgb photon_flux(const Photon *photon);
/* Back along the path, and the normal on the photon's side: unit vectors, kept to some thousandths
 * of a degree and to two and a half degrees. */
void photon_set_direction(Photon *photon, Vec3 unit);
Vec3 photon_direction(const Photon *photon);
void photon_set_normal(Photon *photon, Vec3 unit);
Vec3 photon_normal(const Photon *photon);
/* The three in one call. */
void photon_set_arrival(Photon *photon, Rgb flux, const Vec3 *direction, const Vec3 *normal);

#endif
