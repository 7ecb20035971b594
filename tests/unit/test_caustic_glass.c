/*
 * Caustics of glass against closed forms: the focus and the aberration of a ball, and what a
 * pane lets through.
 */
#include "tests/unit/caustic_check.h"

/* ---- ball ---- */

#define INDEX 1.5

/*
 * A ray that meets a ball of radius 1 at the height h off the axis leaves it, turned by D = 2
 * (asin h - asin(h / n)), on a line that is h off the centre again. Where it crosses the
 * plane at the distance z behind the centre; negative beyond the axis, NaN when it never
 * does.
 */
static double ball_landing(double h, double z)
{
	double turn = 2 * (asin(h) - asin(h / INDEX));
	return turn < M_PI / 2 ? (h - z * sin(turn)) / cos(turn) : NAN;
}

/* The height of the rays that land at the radius r on the paraxial focal plane, where farther
 * out is farther out. */
static double ball_height(double r, double z)
{
	double low = 0, high = 1;
	for (int i = 0; i < 60; i++) {
		double h = (low + high) / 2, landing = ball_landing(h, z);
		if (fabs(landing) < r)
			low = h;
		else
			high = h;
	}
	return low;
}

static PhotonMap *trace_ball(double z)
{
	char text[1000];
	snprintf(text, sizeof text,
	         "#version 3.7;\n"
	         "global_settings { photons { count 250000 } }\n"
	         "light_source { y * 9, 1 parallel point_at 0 photons { refraction on } }\n"
	         "sphere { 0, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } "
		 "  interior { ior %g }\n"
	         "  photons { target refraction on collect off } }\n"
	         "plane { y, %g pigment { rgb 1 } finish { diffuse 1 } }\n", INDEX, -z);
	return caustic_trace(text);
}

static double distance_from_axis(const Photon *photon)
{
	return hypot(photon->position[0], photon->position[2]);
}

/* Parallel light comes to a focus at n / (2 (n - 1)) from the centre; rays off the axis miss
 * it as the closed form says. */
static void test_ball_focus(void)
{
	double z = INDEX / (2 * (INDEX - 1));
	PhotonMap *map = trace_ball(z);
	if (!map)
		return;
	static const double radii[] = {0.002, 0.01, 0.05, 0.1, 0.2, 0.5};
	for (size_t k = 0; k < sizeof radii / sizeof *radii; k++) {
		double flux = 0, h = ball_height(radii[k], z);
		int count = 0;
		for (uint32_t i = 0; i < map->count; i++)
			if (distance_from_axis(&map->photons[i]) < radii[k]) {
				flux += rgb_gray(photon_flux(&map->photons[i]));
				count++;
			}
		CHECK(count > 1000);
		CHECK_NEAR(flux / (M_PI * h * h), 1, 3 / sqrt(fmax(count, 1)));
	}
	photon_map_destroy(map);
}

/* Nearer than the focus the caustic is a ring of the radius at which the landing turns back. */
static void test_ball_ring(double z)
{
	enum { BINS = 60 };
	double ring = 0, width = 0.1 / BINS, density[BINS] = {0};
	for (int i = 0; i < 10000; i++)
		ring = fmax(ring, ball_landing(i / 10000.0 * 0.7, z));
	PhotonMap *map = trace_ball(z);
	if (!map)
		return;
	for (uint32_t i = 0; i < map->count; i++) {
		double r = distance_from_axis(&map->photons[i]);
		if (fabs(r - ring) < 0.05)
			density[(int)((r - ring + 0.05) / width)] += 1 / r;
	}
	int best = 0;
	for (int i = 1; i < BINS; i++)
		if (density[i] > density[best])
			best = i;
	CHECK_NEAR((best + 0.5) * width - 0.05, 0, 2 * width);
	photon_map_destroy(map);
}

/* ---- pane ---- */

/* Fresnel's reflectance of light that is not polarised. */
static double fresnel(double cosine, double n)
{
	double inside = sqrt(1 - (1 - cosine * cosine) / (n * n));
	double s = (cosine - n * inside) / (cosine + n * inside);
	double p = (n * cosine - inside) / (n * cosine + inside);
	return (s * s + p * p) / 2;
}

/* The floor's brightness below a pane in parallel light that falls under the angle (degrees). */
static double brightness_below(double angle, const char *finish)
{
	char text[1200];
	double sine = sin(angle * M_PI / 180), cosine = cos(angle * M_PI / 180);
	snprintf(text, sizeof text,
	         "#version 3.7;\n"
	         "global_settings { max_trace_level 30 photons { count 80000 "
		 "  adc_bailout 0.0001 } }\n"
	         "light_source { <%g, %g, 0>, 1 parallel point_at 0\n"
	         "  photons { refraction on reflection on } }\n"
	         "box { <-3, 0.1, -3>, <3, 0.2, 3> pigment { rgbt 1 } "
		 "  finish { ambient 0 diffuse 0 %s }\n"
	         "  interior { ior %g } photons { target refraction on reflection on "
		 "  collect off } }\n"
	         "plane { y, 0 pigment { rgb 1 } finish { diffuse 1 } }\n",
	         -20 * sine, 20 * cosine, finish, INDEX);
	PhotonMap *map = caustic_trace(text);
	if (!map)
		return 0;
	int count;
	FloorFrame frame = {0, 0, 1, 0};
	double half = 1.5, flux = floor_flux(map, &frame, (double[]){0, half, half}, &count);
	photon_map_destroy(map);
	return flux / (4 * half * half);
}

/*
 * Both faces reflect F; light goes to and fro between them: (1 - F)^2 (1 + F^2 + F^4 ...) =
 * (1 - F) / (1 + F) comes through. Polarisation is not followed: each face sees the mean F.
 */
static void test_pane(void)
{
	static const double angles[] = {0, 30, 55, 75};
	for (size_t i = 0; i < sizeof angles / sizeof *angles; i++) {
		double cosine = cos(angles[i] * M_PI / 180), f = fresnel(cosine, INDEX);
		double clear = brightness_below(angles[i], ""), mirror = brightness_below(angles[i],
			"reflection { 0, 1 fresnel on } conserve_energy");
		CHECK_NEAR(clear / cosine, 1, 0.01);
		CHECK_NEAR(mirror / cosine / ((1 - f) / (1 + f)), 1, 0.01);
	}
}

/* ---- flat faces ---- */

/* Through flat faces all parallel light that takes one way leaves in one direction. */
static void test_faces(void)
{
	PhotonMap *map = caustic_trace(
		"#version 3.7;\n"
		"global_settings { photons { count 2000 } }\n"
		"light_source { <3, 9, 1>, 1 parallel point_at 0 photons { refraction on } }\n"
		"prism { 0, 2, 4, <0, 2>, <-2, -1>, <2, -1>, <0, 2> rotate z * 90\n"
		"  pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.3 }\n"
		"  photons { target refraction on collect off } }\n"
		"plane { y, -5 pigment { rgb 1 } finish { diffuse 1 } }\n");
	enum { WAYS = 65536 };
	static const Photon *first[WAYS];
	int ways = 0, astray = 0;
	for (uint32_t i = 0; map && i < map->count; i++) {
		const Photon *p = &map->photons[i];
		if (!first[p->path])
			ways++;
		else
			astray += vec3_distance(photon_direction(p),
						photon_direction(first[p->path])) > 1e-3;
		first[p->path] = p;
	}
	CHECK(ways >= 3);
	CHECK(astray == 0);
	photon_map_destroy(map);
}

/* Faces that look the same way are told apart by where they are: of the glass' two steps and of the
 * floor's, each pair has light of its own. */
static void test_parallel_faces(void)
{
	PhotonMap *map = caustic_trace(
		"#version 3.7;\n"
		"global_settings { photons { count 2000 } }\n"
		"light_source { <0, 9, 0>, 1 parallel point_at 0 photons { refraction on } }\n"
		"merge { box { <-2, 0, -2>, <2, 1, 2> } box { <0, 0, -2>, <2, 1.2, 2> }\n"
		"  pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 }\n"
		"  photons { target refraction on collect off } }\n"
		"difference { plane { y, -5 } box { <-9, -6, 0>, <9, 0, 9> }\n"
		"  pigment { rgb 1 } finish { diffuse 1 } }\n");
	enum { WAYS = 65536 };
	static uint8_t quadrants[WAYS];
	int astray = 0, seen = 0;
	for (uint32_t i = 0; map && i < map->count; i++) {
		const Photon *p = &map->photons[i];
		uint8_t quadrant = (uint8_t)(1 << ((p->position[0] > 0) + 2 * (p->position[2] > 0)));
		quadrants[p->path] |= quadrant;
		astray += quadrants[p->path] != quadrant;
		seen |= quadrant;
	}
	CHECK(seen == 15);
	CHECK(astray == 0);
	photon_map_destroy(map);
}

int main(void)
{
	test_parallel_faces();
	test_faces();
	test_ball_focus();
	test_ball_ring(1.1);
	test_ball_ring(1.25);
	test_pane();
	return CHECK_RESULT();
}
