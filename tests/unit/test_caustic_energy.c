/*
 * The light that photons bring to a disc of the floor, against closed forms: point, spot and
 * parallel lights, through a slab of glass and through one that bends nothing, fading and not. The
 * slab lies low, so that light which its sides reflect lands beyond the disc.
 */
#include "tests/unit/caustic_check.h"

enum { POINT, SPOT, PARALLEL };

/* The light stands at the height `height` over the middle of the floor, the slab between. */
static const double height = 10, thickness = 0.8, brightness = 0.5, spot_angle = 3,
		    fade_distance = 4;

typedef struct EnergyCase {
	int light;
	double ior;
	bool fades;
	double radius; /* of the floor's disc */
} EnergyCase;

static double fading(const EnergyCase *c, double distance)
{
	double d = distance / fade_distance;
	return c->fades ? 2 / (1 + d * d) : 1;
}

/* Where a ray that leaves the light under the angle lands, and how long its way is: straight but
 * for the slab, in which Snell's law turns it. */
static double landing(const EnergyCase *c, double angle, double *way)
{
	double inner = asin(sin(angle) / c->ior);
	*way = (height - thickness) / cos(angle) + thickness / cos(inner);
	return (height - thickness) * tan(angle) + thickness * tan(inner);
}

/* The angle that lands on the disc's border; a spotlight ends before that. */
static double widest_angle(const EnergyCase *c)
{
	double low = 0, high = M_PI / 4, way;
	for (int i = 0; i < 60; i++) {
		double middle = (low + high) / 2;
		if (landing(c, middle, &way) < c->radius)
			low = middle;
		else
			high = middle;
	}
	return c->light == SPOT ? fmin(low, spot_angle * M_PI / 180) : low;
}

/*
 * A light of colour b sends b D^2 fading(D) into a solid angle, as it counts where it lands after
 * the way D: so POV-Ray's lights are as bright behind a pane as without it. Under parallel light
 * every place of the floor shows b fading(D).
 */
static double closed_form(const EnergyCase *c)
{
	enum { STEPS = 1000 };
	double angle = widest_angle(c), sum = 0, way;
	if (c->light == PARALLEL)
		return brightness * fading(c, height) * M_PI * c->radius * c->radius;
	for (int i = 0; i < STEPS; i++) {
		double a = (i + 0.5) / STEPS * angle;
		landing(c, a, &way);
		sum += 2 * M_PI * sin(a) * way * way * fading(c, way) * angle / STEPS;
	}
	return brightness * sum;
}

static PhotonMap *trace_case(const EnergyCase *c)
{
	static const char *const lights[] = {
		"", "spotlight point_at 0 radius 3 falloff 3 tightness 0", "parallel point_at 0"};
	char text[1200];
	snprintf(text, sizeof text,
	         "#version 3.7;\n"
	         "global_settings { photons { count 100000 } }\n"
	         "light_source { <0, %g, 0>, %g %s %s photons { refraction on } }\n"
	         "box { <-1.5, 0.5, -1.5>, <1.5, %g, 1.5> pigment { rgbt 1 } "
		 "  finish { ambient 0 diffuse 0 }\n"
	         "  interior { ior %g } photons { target refraction on collect off } }\n"
	         "plane { y, 0 pigment { rgb 1 } finish { diffuse 1 } }\n",
	         height, brightness, lights[c->light],
		 c->fades ? "fade_distance 4 fade_power 2" : "",
	         0.5 + thickness, c->ior);
	return caustic_trace(text);
}

static void check_case(const EnergyCase *c)
{
	double flux = 0;
	uint32_t count = 0;
	PhotonMap *map = trace_case(c);
	if (!map)
		return;
	for (uint32_t i = 0; i < map->count; i++) {
		const Photon *p = &map->photons[i];
		if (hypot(p->position[0], p->position[2]) >= c->radius)
			continue;
		flux += rgb_gray(photon_flux(p));
		count++;
	}
	CHECK(count > 5000);
	CHECK_NEAR(flux / closed_form(c), 1, 0.01);
	photon_map_destroy(map);
}

int main(void)
{
	static const double iors[] = {1, 1.5, 2.4};
	for (int light = POINT; light <= PARALLEL; light++)
		for (int i = 0; i < 3; i++)
			for (int fades = 0; fades < 2; fades++)
				check_case(&(EnergyCase){light, iors[i], fades, 0.8});
	return CHECK_RESULT();
}
