/* What lights send, against closed forms. */
#include "light/area.h"
#include "light/emission.h"
#include "light/light.h"

#include "check.h"

static const double PI = 3.14159265358979323846;

static Light light_at(Vec3 position)
{
	Light light = light_default();
	light.position = position;
	light.point_at = vec3(0, 0, 0);
	return light;
}

static double arrival(const Light *light, Vec3 p)
{
	Vec3 direction;
	double distance;
	Rgb color = light_arrival(light, light->position, p, &direction, &distance);
	CHECK_NEAR(vec3_length(direction), 1, 1e-12);
	CHECK_NEAR(color.r, color.b, 0);
	return color.r;
}

static void check_point_light(void)
{
	Light light = light_at(vec3(0, 10, 0));
	CHECK_NEAR(arrival(&light, vec3(3, 0, 0)), 1, 0);
	Vec3 direction;
	double distance;
	light_arrival(&light, light.position, vec3(0, 4, 0), &direction, &distance);
	CHECK_NEAR(direction.y, 1, 1e-12);
	CHECK_NEAR(distance, 6, 1e-12);
	light.fade_distance = 2;
	light.fade_power = 2;
	CHECK_NEAR(arrival(&light, vec3(0, 8, 0)), 1, 1e-6);
	CHECK_NEAR(arrival(&light, vec3(0, 0, 0)), 2 / (1 + 25.0), 1e-6);
}

/* A fading light of power 2 far away goes as 2 (d0/r)^2: its flux through any far sphere is 8 pi
 * d0^2. */
static void check_flux(void)
{
	Light light = light_at(vec3(0, 0, 0));
	light.fade_distance = 0.01;
	light.fade_power = 2;
	for (double radius = 10; radius < 1e4; radius *= 10) {
		double flux = arrival(&light, vec3(radius, 0, 0)) * 4 * PI * radius * radius;
		CHECK_NEAR(flux, 8 * PI * 1e-4, 1e-6);
	}
}

static void check_spot(void)
{
	Light light = light_at(vec3(0, 10, 0));
	light.kind = LIGHT_SPOT;
	light.radius = cos(20 * PI / 180);
	light.falloff = cos(40 * PI / 180);
	CHECK_NEAR(arrival(&light, vec3(0, 0, 0)), 1, 1e-6);
	CHECK_NEAR(arrival(&light, vec3(10 * tan(19 * PI / 180), 0, 0)), 1, 1e-6);
	CHECK_NEAR(arrival(&light, vec3(10 * tan(41 * PI / 180), 0, 0)), 0, 0);
	double middle = acos((light.radius + light.falloff) / 2);
	CHECK_NEAR(arrival(&light, vec3(10 * tan(middle), 0, 0)), 0.5, 1e-6);
	light.tightness = 3;
	CHECK_NEAR(arrival(&light, vec3(10 * tan(0.1), 0, 0)), pow(cos(0.1), 3), 1e-6);
	CHECK_NEAR(arrival(&light, vec3(0, 20, 0)), 0, 0);
}

static void check_cylinder(void)
{
	Light light = light_at(vec3(0, 10, 0));
	light.kind = LIGHT_CYLINDER;
	light.radius = 1;
	light.falloff = 3;
	CHECK_NEAR(arrival(&light, vec3(0.9, 0, 0)), 1, 1e-6);
	CHECK_NEAR(arrival(&light, vec3(2, -7, 0)), 0.5, 1e-6);
	CHECK_NEAR(arrival(&light, vec3(3.1, 0, 0)), 0, 0);
}

static void check_parallel(void)
{
	Light light = light_at(vec3(0, 10, 0));
	light.parallel = true;
	Vec3 direction;
	double distance;
	light_arrival(&light, light.position, vec3(100, 3, 5), &direction, &distance);
	CHECK_NEAR(direction.y, 1, 1e-12);
	CHECK_NEAR(distance, 7, 1e-12);
}

static void check_area(void)
{
	Light light = light_at(vec3(1, 2, 3));
	light.area = true;
	light.axis1 = vec3(4, 0, 0);
	light.axis2 = vec3(0, 0, 4);
	light.size1 = light.size2 = 5;
	AreaFrame frame = area_frame(&light, vec3(0, 0, 0));
	Vec3 corner = area_point(&light, &frame, 0, 4);
	CHECK_NEAR(vec3_distance(corner, vec3(-1, 2, 5)), 0, 1e-12);
	light.circular = true;
	corner = area_point(&light, &frame, 0, 4);
	CHECK_NEAR(vec3_distance(corner, light.position), 2, 1e-12);
	light.orient = true;
	Vec3 p = vec3(7, -1, 2), view = vec3_sub(p, light.position);
	frame = area_frame(&light, p);
	CHECK_NEAR(vec3_dot(frame.axis1, view), 0, 1e-9);
	CHECK_NEAR(vec3_dot(frame.axis2, view), 0, 1e-9);
	CHECK_NEAR(vec3_dot(frame.axis1, frame.axis2), 0, 1e-9);
	CHECK_NEAR(vec3_length(frame.axis1), 4, 1e-9);
}

/* How far along a rectangle's side a point of the plane lies: from -1 to 1 inside. */
static double share_along(Vec2 at, Vec2 side)
{
	return (at.u * side.u + at.v * side.v) / (side.u * side.u + side.v * side.v);
}

/* A parallel light's rectangle holds the shadow of every corner, is less than the disc around it,
 * and emissions fill it. */
static void check_rectangle(void)
{
	Light light = light_at(vec3(3, 10, -2));
	light.parallel = true;
	EmissionAim aim = {.center = {1, 2, 3}, .half = {4, 0.5, 2}};
	aim.radius = vec3_length(aim.half);
	EmissionRegion region = emission_region(&light, &aim);
	CHECK(region.rectangle && region.measure < 0.7 * PI * aim.radius * aim.radius);
	for (int i = 0; i < 8; i++) {
		Vec3 corner = vec3(i & 1 ? 4 : -4, i & 2 ? 0.5 : -0.5, i & 4 ? 2 : -2);
		Vec2 at = {vec3_dot(corner, region.u), vec3_dot(corner, region.v)};
		CHECK(fabs(share_along(at, region.side)) < 1 + 1e-12);
		CHECK(fabs(share_along(at, region.across)) < 1 + 1e-12);
	}
	double most = 0;
	for (int i = 0; i < 1000; i++) {
		double s = i / 1000.0, t = i * 0.618 - floor(i * 0.618);
		Emission emission;
		emission_run(&region, 1, &s, &t, &emission);
		Vec2 at = {emission.coordinates[0] - region.middle.u,
			   emission.coordinates[1] - region.middle.v};
		double a = share_along(at, region.side), b = share_along(at, region.across);
		CHECK(fabs(a) < 1 + 1e-6 && fabs(b) < 1 + 1e-6);
		most = fmax(most, fmin(a, b));
	}
	/* A thousand points come about as near to the corner as 2 / sqrt(1000). */
	CHECK(most > 0.9);
}

int main(void)
{
	check_rectangle();
	check_point_light();
	check_flux();
	check_spot();
	check_cylinder();
	check_parallel();
	check_area();
	return CHECK_RESULT();
}
