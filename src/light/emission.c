#include "light/emission.h"

#include <math.h>

#include "light/area.h"

static bool is_collimated(const Light *light)
{
	return light->parallel || light->kind == LIGHT_CYLINDER;
}

static Vec3 light_axis(const Light *light)
{
	return vec3_normalize(vec3_sub(light->point_at, light->position));
}

int emission_dimensions(const Light *light)
{
	return is_collimated(light) ? 2 : 3;
}

/* ---- regions ---- */

static double reach_of(const EmissionAim *aim)
{
	return aim->reach > 0 ? aim->reach : 1;
}

/* The rectangle of the plane along one of the box's sides that covers the box; false when the side
 * is seen end on. */
static bool rectangle_along(const Vec2 sides[3], int along, EmissionRegion *region)
{
	double length = hypot(sides[along].u, sides[along].v), a = 0, b = 0;
	if (!(length > 0))
		return false;
	Vec2 to = {sides[along].u / length, sides[along].v / length};
	for (int i = 0; i < 3; i++) {
		a += fabs(sides[i].u * to.u + sides[i].v * to.v);
		b += fabs(sides[i].v * to.u - sides[i].u * to.v);
	}
	region->side = (Vec2){a * to.u, a * to.v};
	region->across = (Vec2){-b * to.v, b * to.u};
	region->measure = 4 * a * b;
	return true;
}

/* Takes the least rectangle that covers the box's shadow where that is less than the disc. */
static void try_rectangles(const EmissionAim *aim, EmissionRegion *region)
{
	Vec3 u = region->u, v = region->v, h = aim->half;
	Vec2 sides[3] = {{h.x * u.x, h.x * v.x}, {h.y * u.y, h.y * v.y}, {h.z * u.z, h.z * v.z}};
	for (int i = 0; i < 3; i++) {
		EmissionRegion other = *region;
		other.rectangle = true;
		if (rectangle_along(sides, i, &other) && other.measure < region->measure)
			*region = other;
	}
}

/* The disc of the light's plane that the ball throws its shadow on; a cylinder light's own disc
 * when that is smaller. Paths start before the ball even where the light's plane cuts it. */
static EmissionRegion disc_region(const Light *light, const EmissionAim *aim)
{
	EmissionRegion region = {
		.plane = true, .axis = light_axis(light), .radius = aim->radius * reach_of(aim)};
	Vec3 offset = vec3_sub(aim->center, light->position);
	double along = vec3_dot(offset, region.axis);
	region.origin = vec3_mad(aim->center, -along, region.axis);
	if (light->kind == LIGHT_CYLINDER && light->falloff < region.radius) {
		region.own = true;
		region.origin = light->position;
		region.radius = light->falloff;
	}
	vec3_frame(region.axis, &region.u, &region.v);
	Vec3 from = vec3_sub(region.origin, light->position);
	region.middle = (Vec2){vec3_dot(from, region.u), vec3_dot(from, region.v)};
	region.origin = vec3_mad(region.origin, real_min(along - aim->radius, 0), region.axis);
	region.measure = M_PI * region.radius * region.radius;
	if (!region.own && reach_of(aim) >= 1)
		try_rectangles(aim, &region);
	return region;
}

/* The cap of directions under which the ball is seen; a spotlight's own cone when that is smaller.
 */
static EmissionRegion cap_region(const Light *light, Vec3 origin, const EmissionAim *aim)
{
	EmissionRegion region = {.origin = origin};
	Vec3 offset = vec3_sub(aim->center, origin);
	double sine = aim->radius / vec3_length(offset);
	region.axis = vec3_normalize(offset);
	/* 1 - cos without cancellation for small balls */
	region.rise = sine < 1 ? sine * sine / (1 + sqrt(1 - sine * sine)) : 2;
	region.rise *= reach_of(aim) * reach_of(aim);
	if (light->kind == LIGHT_SPOT && 1 - light->falloff < region.rise) {
		region.own = true;
		region.axis = light_axis(light);
		region.rise = fmin(1 - light->falloff, 1);
	}
	if (vec3_length2(region.axis) == 0)
		region.axis = vec3(0, 1, 0);
	vec3_frame(region.axis, &region.u, &region.v);
	region.measure = 2 * M_PI * region.rise;
	return region;
}

EmissionRegion emission_region(const Light *light, const EmissionAim *aim)
{
	return is_collimated(light) ? disc_region(light, aim)
				    : cap_region(light, light->position, aim);
}

/* ---- samples ---- */

/* Compiled for wide registers as well; lanes do not change the bits. */
#if defined(__x86_64__)
#define CLONES __attribute__((target_clones("avx2", "default")))
#else
#define CLONES
#endif

enum { TERMS = 9 };

/* Taylor series by y = x^2, highest power first, of the cosine of x and of the sine over x: for |x|
 * <= pi / 4 to where a double's last bit ends. */
static const double cosine_terms[TERMS] = {
	1.0 / 20922789888000, -1.0 / 87178291200, 1.0 / 479001600, -1.0 / 3628800, 1.0 / 40320,
	-1.0 / 720, 1.0 / 24, -1.0 / 2, 1};
static const double sine_terms[TERMS] = {
	1.0 / 355687428096000, -1.0 / 1307674368000, 1.0 / 6227020800, -1.0 / 39916800,
	1.0 / 362880, -1.0 / 5040, 1.0 / 120, -1.0 / 6, 1};

static inline double series(const double terms[TERMS], double y)
{
	double sum = terms[0] * y + terms[1];
	sum = sum * y + terms[2];
	sum = sum * y + terms[3];
	sum = sum * y + terms[4];
	sum = sum * y + terms[5];
	sum = sum * y + terms[6];
	sum = sum * y + terms[7];
	return sum * y + terms[8];
}

/* Points (s, t) of the unit square to the unit disc, areas kept, neighbours kept (Shirley & Chiu
 * 1997). */
CLONES static void concentric_discs(int count, double *s, double *t)
{
#pragma omp simd
	for (int i = 0; i < count; i++) {
		double a = 2 * s[i] - 1, b = 2 * t[i] - 1;
		/* Choices as products with 0 and 1, which lanes can take. */
		double wide = fabs(a) > fabs(b), high = 1 - wide;
		double r = wide * a + high * b, across = wide * b + high * a;
		double x = M_PI / 4 * (across / (r + (r == 0))), y = x * x;
		double cosine = r * series(cosine_terms, y), sine = r * x * series(sine_terms, y);
		s[i] = wide * cosine + high * sine;
		t[i] = wide * sine + high * cosine;
	}
}

bool emission_takes_point(const Light *light)
{
	return light->photons_area && light->area;
}

static Vec3 area_origin(const Light *light, const EmissionAim *aim, const double s[2])
{
	AreaFrame frame = area_frame(light, aim->center);
	return area_point(light, &frame, s[0] * (light->size1 - 1), s[1] * (light->size2 - 1));
}

/* At a point of the plane, from the region's middle. */
static void sample_plane(const EmissionRegion *region, double u, double v, Emission *out)
{
	out->origin = vec3_mad(vec3_mad(region->origin, u, region->u), v, region->v);
	out->direction = region->axis;
	out->coordinates[0] = (float)(region->middle.u + u);
	out->coordinates[1] = (float)(region->middle.v + v);
	out->coordinates[2] = 0;
	out->measure = region->measure;
}

static void sample_rectangle(const EmissionRegion *region, int count, const double *s,
			     const double *t, Emission *out)
{
	for (int i = 0; i < count; i++) {
		double a = 2 * s[i] - 1, b = 2 * t[i] - 1;
		sample_plane(region, a * region->side.u + b * region->across.u,
			     a * region->side.v + b * region->across.v, &out[i]);
	}
}

static void sample_disc(const EmissionRegion *region, int count, const double *u, const double *v,
			Emission *out)
{
	for (int i = 0; i < count; i++)
		sample_plane(region, region->radius * u[i], region->radius * v[i], &out[i]);
}

/* A disc's squared radius is uniform, and so is the height of a cap; the sine over the disc's
 * radius is what its point is stretched with. */
CLONES static void find_cap_directions(const EmissionRegion *region, int count, const double *u,
				       const double *v, double *to[3])
{
	Vec3 axis = region->axis, x = region->u, y = region->v;
	double rise = region->rise;
#pragma omp simd
	for (int i = 0; i < count; i++) {
		double down = rise * (u[i] * u[i] + v[i] * v[i]), up = 1 - down;
		double stretch = sqrt(real_max(rise * (2 - down), 0));
		double a = stretch * u[i], b = stretch * v[i];
		Vec3 out = vec3_unit_again(vec3(up * axis.x + (a * x.x + b * y.x),
						up * axis.y + (a * x.y + b * y.y),
						up * axis.z + (a * x.z + b * y.z)));
		to[0][i] = out.x;
		to[1][i] = out.y;
		to[2][i] = out.z;
	}
}

static void sample_cap(const EmissionRegion *region, int count, const double *u, const double *v,
		       Emission *out)
{
	double x[EMISSION_RUN_MAX], y[EMISSION_RUN_MAX], z[EMISSION_RUN_MAX], *to[] = {x, y, z};
	find_cap_directions(region, count, u, v, to);
	for (int i = 0; i < count; i++) {
		out[i].origin = region->origin;
		out[i].direction = vec3(x[i], y[i], z[i]);
		out[i].coordinates[0] = (float)x[i];
		out[i].coordinates[1] = (float)y[i];
		out[i].coordinates[2] = (float)z[i];
		out[i].measure = region->measure;
	}
}

static void sample_round(const EmissionRegion *region, int count, const double *u, const double *v,
			 Emission *out)
{
	if (region->plane)
		sample_disc(region, count, u, v, out);
	else
		sample_cap(region, count, u, v, out);
}

Emission emission_from_disc(const EmissionRegion *region, Vec2 disc)
{
	Emission out;
	sample_round(region, 1, &disc.u, &disc.v, &out);
	return out;
}

void emission_run(const EmissionRegion *region, int count, double *s, double *t, Emission *out)
{
	if (region->rectangle) {
		sample_rectangle(region, count, s, t, out);
		return;
	}
	concentric_discs(count, s, t);
	sample_round(region, count, s, t, out);
}

EmissionRegion emission_region_from(const Light *light, const EmissionAim *aim, const double s[2])
{
	return cap_region(light, area_origin(light, aim, s), aim);
}

/* As light_arrival, for lights that are as strong in all directions: how far the light has come is
 * known from the ray. */
static Rgb even_arrival(const Light *light, const Emission *emission, Vec3 p, double *distance)
{
	Vec3 from = light->parallel ? light->position : emission->origin;
	*distance = fabs(vec3_dot(vec3_sub(p, from), emission->direction));
	return rgb_scale(light->color, (float)light_fade(light, *distance));
}

Rgb emission_flux(const Light *light, const Emission *emission, Vec3 p, double share,
		  double *distance)
{
	Vec3 direction;
	double area = share * emission->measure;
	Rgb arrival = light->kind == LIGHT_POINT
			      ? even_arrival(light, emission, p, distance)
			      : light_arrival(light,
					      is_collimated(light) ? light->position
								   : emission->origin,
					      p, &direction, distance);
	if (!is_collimated(light))
		area *= *distance * *distance;
	return rgb_scale(arrival, (float)area);
}

double emission_growth(const Light *light, double distance, double farther)
{
	double fading = light_fade(light, farther) / light_fade(light, distance);
	double spread = farther / distance;
	return is_collimated(light) ? fading : fading * spread * spread;
}
