/* Eye rays: corners of each projection, and focal blur that meets in the plane in focus. */
#include "scene/camera.h"

#include "check.h"

static const double PI = 3.14159265358979323846;
static const Vec2 PINHOLE = {0.5, 0.5};

static Ray ray_of(const Camera *camera, double x, double y)
{
	Ray ray;
	CHECK(camera_ray(camera, x, y, 8, 6, PINHOLE, &ray));
	CHECK_NEAR(vec3_length(ray.direction), 1, 1e-12);
	return ray;
}

static void check_direction(Ray ray, double x, double y, double z)
{
	Vec3 expected = vec3_normalize(vec3(x, y, z));
	CHECK_NEAR(vec3_distance(ray.direction, expected), 0, 1e-5);
}

static void check_perspective(void)
{
	Camera camera = camera_default(4.0 / 3);
	check_direction(ray_of(&camera, 4, 3), 0, 0, 1);
	check_direction(ray_of(&camera, 0, 0), -2.0 / 3, 0.5, 1);
	camera.angle = 90;
	check_direction(ray_of(&camera, 8, 3), 1, 0, 1);
	camera.kind = CAMERA_ORTHOGRAPHIC;
	Ray ray = ray_of(&camera, 8, 0);
	check_direction(ray, 0, 0, 1);
	CHECK_NEAR(vec3_distance(ray.origin, vec3(2.0 / 3, 0.5, 0)), 0, 1e-12);
}

/* Directions that POV-Ray's images of a coloured sky showed. */
static void check_round_projections(void)
{
	Camera camera = camera_default(4.0 / 3);
	camera.kind = CAMERA_FISHEYE;
	camera.angle = 180;
	Ray ray;
	CHECK(!camera_ray(&camera, 0, 0, 8, 6, PINHOLE, &ray));
	check_direction(ray_of(&camera, 4, 0), 0, 1, 0);
	camera.kind = CAMERA_SPHERICAL;
	check_direction(ray_of(&camera, 6, 3), 1, 0, 0);
	check_direction(ray_of(&camera, 4, 1.5), 0, 1, 1);
	camera.kind = CAMERA_PANORAMIC;
	double turn = 0.4375 * PI, rise = 0.25 * PI;
	check_direction(ray_of(&camera, 7.5, 1.5), 4.0 / 3 * sin(turn), tan(rise), cos(turn));
	camera.kind = CAMERA_ULTRA_WIDE;
	check_direction(ray_of(&camera, 6, 3), sin(PI / 4), 0, cos(PI / 4));
	camera.kind = CAMERA_CYLINDER;
	camera.cylinder = 1;
	check_direction(ray_of(&camera, 6, 0), sin(PI / 4), 0.5, cos(PI / 4));
	camera.cylinder = 4;
	ray = ray_of(&camera, 8, 0);
	check_direction(ray, 0, 1, 0);
	CHECK_NEAR(ray.origin.x, 2.0 / 3, 1e-12);
}

static void check_omnimax(void)
{
	Camera camera = camera_default(1);
	camera.kind = CAMERA_OMNIMAX;
	Ray ray;
	CHECK(!camera_ray(&camera, 7.3333, 3.75, 8, 6, PINHOLE,
			  &ray)); /* more than 45 degrees down, seen from the side */
	double theta = 0.5 * (1.411269 - 0.09439 * 0.25 + 0.25674 * 0.0625);
	check_direction(ray_of(&camera, 4, 1.5), 0, sin(theta), cos(theta));
	camera.right = vec3(4.0 / 3, 0, 0);
	theta = 0.22086 * (1.411269 - 0.09439 * 0.04878 + 0.25674 * 0.002379);
	check_direction(ray_of(&camera, 4, 3), 0, sin(theta), cos(theta));
}

static void check_focus(void)
{
	Camera camera = camera_default(1);
	camera.aperture = 0.7;
	camera.has_focal_point = true;
	camera.focal_point = vec3(1, 2, 9);
	Vec3 meet = {0, 0, 0};
	double farthest = 0;
	for (int i = 0; i < 25; i++) {
		Ray ray;
		Vec2 lens = {i % 5 / 4.0, i / 5 / 4.0};
		CHECK(camera_ray(&camera, 3, 1, 8, 6, lens, &ray));
		Vec3 at = ray_at(&ray, (9 - ray.origin.z) / ray.direction.z);
		if (i == 0)
			meet = at;
		CHECK_NEAR(vec3_distance(at, meet), 0, 1e-9);
		farthest = fmax(farthest, vec3_length(ray.origin));
	}
	CHECK_NEAR(farthest, 0.175, 1e-9); /* a quarter of the aperture, as in POV-Ray */
}

int main(void)
{
	check_perspective();
	check_round_projections();
	check_omnimax();
	check_focus();
	return CHECK_RESULT();
}
