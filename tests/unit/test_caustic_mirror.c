/*
 * Caustics of mirrors against closed forms: parallel light in a ring (nephroid), a lamp on
 * the ring's rim (cardioid), and a paraboloid, which brings parallel light to one point.
 *
 * The ring has radius 1. What slants down keeps its slope at an upright mirror, so seen from
 * above everything happens in a plane, and the floor shows the plane's caustic. A fan of rays
 * that falls on the wall under the angle i is focused at 1/s' + 1/s = 2 / cos i (Coddington's
 * equation for a mirror); on the floor its density is that before the mirror over |1 - s/s'|.
 */
#include "tests/unit/caustic_check.h"

#define FLOOR_AND_MIRROR                                                                           \
	"plane { y, 0 pigment { rgb 1 } finish { diffuse 1 } }\n"                                  \
	"#declare Mirror = texture { pigment { rgb 1 } " \
	"  finish { ambient 0 diffuse 0 reflection 1 } };\n"

/* Only a third of the ring, lest light be reflected twice. */
#define RING(HEIGHT, BOX) \
	"intersection {\n" \
	"  difference { cylinder { 0, y * " HEIGHT ", 1.01 } cylinder { -y, y * 2, 1 } }\n" \
	"  box { " BOX " }\n" \
	"  texture { Mirror } photons { target reflection on collect off }\n" \
	"}\n"

/* Where across the frame (b) photons are densest, looking at |a| < half_a and |b| < 0.1. */
static double floor_peak(const PhotonMap *map, const FloorFrame *frame, double half_a)
{
	enum { BINS = 40 };
	double width = 0.2 / BINS;
	int bins[BINS] = {0}, best = 0;
	for (uint32_t i = 0; i < map->count; i++) {
		double a, b;
		floor_coordinates(frame, &map->photons[i], &a, &b);
		if (fabs(a) < half_a && fabs(b) < 0.1)
			bins[(int)((b + 0.1) / width)]++;
	}
	for (int i = 1; i < BINS; i++)
		if (bins[i] > bins[best])
			best = i;
	return (best + 0.5) * width - 0.1;
}

/* Compares the flux in a rectangle with density x area; the tolerance is three sigmas of the
 * count and a little for the density's change across the rectangle. */
static void check_density(const PhotonMap *map, const FloorFrame *frame,
                          const double rectangle[3], double density)
{
	int count;
	double flux = floor_flux(map, frame, rectangle, &count);
	double expected = density * 4 * rectangle[1] * rectangle[2];
	CHECK(count > 300);
	CHECK_NEAR(flux / expected, 1, 0.02 + 3 / sqrt(fmax(count, 1)));
}

/* The mean of a function over [x - half, x + half]. */
static double mean(double function(double x), double x, double half)
{
	enum { STEPS = 50 };
	double sum = 0;
	for (int i = 0; i < STEPS; i++)
		sum += function(x + half * (2 * (i + 0.5) / STEPS - 1));
	return sum / STEPS;
}

/* ---- nephroid ---- */

/* On the axis at x: the ray reflected at the wall's middle, and for x > 1/2 the two from cos
 * i = 1 / (2 x). Light falls with the slope 1/2; without the mirror's focusing the floor
 * would receive the sine of that. */
static double nephroid_density(double x)
{
	double sine = 1 / sqrt(5);
	return sine * (1 / fabs(2 * x - 1) + (x > 0.5 ? 2 / (4 * x * x - 1) : 0));
}

/* The caustic's point of the ray that meets the wall under the angle i, and the ray's way
 * there. */
static FloorFrame nephroid_fold(double i)
{
	double cosine = cos(i), sine = sin(i);
	return (FloorFrame){cosine * (1.5 - cosine * cosine), sine * sine * sine,
	                    -cos(2 * i), -sin(2 * i)};
}

static void test_nephroid(void)
{
	PhotonMap *map = caustic_trace(
		"#version 3.7;\n" FLOOR_AND_MIRROR RING("0.6", "<0.643, -1, -2>, <2, 2, 2>")
		"global_settings { photons { count 500000 } }\n"
		"light_source { <-20, 10, 0>, 1 parallel point_at 0 photons { reflection on } }\n");
	if (!map)
		return;
	FloorFrame axis = {0, 0, 1, 0}, across = {0.5, 0, 0, 1};
	for (int i = 0; i < 4; i++) {
		double x = -0.05 + 0.1 * i;
		check_density(map, &axis, (double[]){x, 0.05, 0.03},
			      mean(nephroid_density, x, 0.05));
	}
	check_density(map, &axis, (double[]){0.70, 0.05, 0.02}, mean(nephroid_density, 0.70, 0.05));
	CHECK_NEAR(floor_peak(map, &across, 0.001), 0, 0.011); /* the cusp at half the radius */
	for (int side = -1; side <= 1; side += 2)
		for (int i = 25; i <= 45; i += 5) {
			FloorFrame fold = nephroid_fold(side * i * M_PI / 180);
			CHECK_NEAR(floor_peak(map, &fold, 0.02), 0, 0.011);
		}
	photon_map_destroy(map);
}

/* ---- cardioid ---- */

enum { LAMP_HEIGHT_2 = 3 }; /* twice the lamp's height over the floor */

/* On the axis between the cusp and the lamp at x = 1: one ray, reflected at x = -1. The
 * lamp's light does not fade with distance: the floor shows it as bright as the wall does,
 * but for the slant and the mirror's focusing. */
static double cardioid_density(double x)
{
	double chord = 2, s = x + 1, focus = chord / 3, height = LAMP_HEIGHT_2 / 2.0;
	double down = atan(height / (chord + s));
	double way = (chord + s) / chord, spread = fabs(1 - s / focus);
	return chord * sin(down) * sin(down) / (height * cos(down) * spread) * way * way;
}

static FloorFrame cardioid_fold(double i)
{
	double wall_x = -cos(2 * i), wall_z = sin(2 * i), chord = 2 * cos(i);
	double in_x = (wall_x - 1) / chord, in_z = wall_z / chord,
	       along = in_x * wall_x + in_z * wall_z;
	double x = in_x - 2 * along * wall_x, z = in_z - 2 * along * wall_z, s = chord / 3;
	return (FloorFrame){wall_x + s * x, wall_z + s * z, x, z};
}

static void test_cardioid(void)
{
	PhotonMap *map = caustic_trace(
		"#version 3.7;\n" FLOOR_AND_MIRROR RING("1", "<-2, -1, -2>, <-0.643, 2, 2>")
		"global_settings { photons { count 500000 } }\n"
		"light_source { <1, 1.5, 0>, 1 photons { reflection on } }\n");
	if (!map)
		return;
	FloorFrame axis = {0, 0, 1, 0}, across = {-1.0 / 3, 0, 0, 1};
	for (int i = 0; i < 5; i++) {
		double x = -0.05 + 0.1 * i;
		check_density(map, &axis, (double[]){x, 0.05, 0.03},
			      mean(cardioid_density, x, 0.05));
	}
	CHECK_NEAR(floor_peak(map, &across, 0.001), 0,
		   0.011); /* the cusp at a third of the radius */
	for (int side = -1; side <= 1; side += 2)
		for (int i = 14; i <= 23; i += 3) {
			FloorFrame fold = cardioid_fold(side * i * M_PI / 180);
			CHECK_NEAR(floor_peak(map, &fold, 0.02), 0, 0.011);
		}
	photon_map_destroy(map);
}

/* ---- paraboloid ---- */

/* Everything but what the screen shades reaches the focus at <0, 1, 0>. */
static void test_paraboloid(void)
{
	PhotonMap *map = caustic_trace(
		"#version 3.7;\n" FLOOR_AND_MIRROR
		"intersection {\n"
		"  quadric { <1, 0, 1>, <0, 0, 0>, <0, -4, 0>, 0 inverse }\n"
		"  cylinder { y * -0.1, y * 0.25, 1 }\n"
		"  texture { Mirror } photons { target reflection on collect off }\n"
		"}\n"
		"disc { y, y, 0.1 pigment { rgb 1 } finish { diffuse 1 } }\n"
		"global_settings { photons { count 200000 } }\n"
		"light_source { y * 9, 1 parallel point_at 0 photons { reflection on } }\n");
	if (!map)
		return;
	double flux = 0, farthest = 0;
	for (uint32_t i = 0; i < map->count; i++) {
		const float *p = map->photons[i].position;
		farthest = fmax(farthest,
				sqrt(p[0] * p[0] + (p[1] - 1) * (p[1] - 1) + p[2] * p[2]));
		flux += rgb_gray(photon_flux(&map->photons[i]));
	}
	CHECK(farthest < 1e-5);
	CHECK_NEAR(flux / (M_PI * (1 - 0.1 * 0.1)), 1, 0.01);
	photon_map_destroy(map);
}

int main(void)
{
	test_nephroid();
	test_cardioid();
	test_paraboloid();
	return CHECK_RESULT();
}
