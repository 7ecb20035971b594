/*
 * Every projection is a function from a point of the image, x and y in [-1/2, 1/2] with y upward,
 * to a ray in the frame of direction, right and up. The formulas follow POV-Ray 3.7's manual,
 * section 3.4.2.2; what it leaves open (which lengths count) was measured from its images.
 */
#include "scene/camera.h"

#include <math.h>

#include "base/transform.h"

static const double PI = 3.14159265358979323846;

typedef struct ImagePoint {
	double x, y;          /* -1/2 .. 1/2, y upward */
	double width, height; /* pixels */
} ImagePoint;

typedef bool Projection(const Camera *camera, const ImagePoint *at, Ray *ray);

Camera camera_default(double aspect)
{
	return (Camera){
		.kind = CAMERA_PERSPECTIVE,
		.direction = {0, 0, 1},
		.right = {aspect, 0, 0},
		.up = {0, 1, 0},
		.sky = {0, 1, 0},
		.h_angle = 360,
		.v_angle = 180,
		.blur_samples_min = 0,
		.confidence = 0.9,
		.variance = 1.0 / 10000,
	};
}

static double radians(double degrees)
{
	return degrees * PI / 180;
}

/* a u + b v + c w */
static Vec3 combine(Vec3 u, double a, Vec3 v, double b, Vec3 w, double c)
{
	return vec3_add(vec3_add(vec3_scale(u, a), vec3_scale(v, b)), vec3_scale(w, c));
}

static bool project_perspective(const Camera *camera, const ImagePoint *at, Ray *ray)
{
	double length = 1;
	if (camera->angle > 0)
		length = vec3_length(camera->right) / (2 * tan(radians(camera->angle) / 2)) /
			 vec3_length(camera->direction);
	ray->direction = combine(camera->right, at->x, camera->up, at->y, camera->direction,
				 length);
	return true;
}

static bool project_orthographic(const Camera *camera, const ImagePoint *at, Ray *ray)
{
	ray->origin = combine(camera->right, at->x, camera->up, at->y, camera->location, 1);
	ray->direction = camera->direction;
	return true;
}

/* A direction at the angle theta from the view, towards (x, y) of length radius in the image plane.
 */
static Vec3 polar_direction(const Camera *camera, const ImagePoint *at, double radius, double theta)
{
	double scale = radius > 0 ? sin(theta) / radius : 0;
	return combine(vec3_normalize(camera->right), at->x * scale, vec3_normalize(camera->up),
		       at->y * scale, vec3_normalize(camera->direction), cos(theta));
}

static bool project_fisheye(const Camera *camera, const ImagePoint *at, Ray *ray)
{
	ImagePoint disc = *at;
	disc.x *= 2 * vec3_length(camera->right);
	disc.y *= 2 * vec3_length(camera->up);
	double radius = hypot(disc.x, disc.y);
	double angle = camera->angle > 0 ? camera->angle : 180;
	ray->direction = polar_direction(camera, &disc, radius, radius * radians(angle) / 2);
	return radius <= 1;
}

static bool project_ultra_wide(const Camera *camera, const ImagePoint *at, Ray *ray)
{
	double angle = radians(camera->angle > 0 ? camera->angle : 180);
	double x = at->x * angle;
	double y = at->y * angle * vec3_length(camera->up) / vec3_length(camera->right);
	ray->direction = combine(vec3_normalize(camera->right), sin(x), vec3_normalize(camera->up),
				 sin(y), vec3_normalize(camera->direction), cos(x) * cos(y));
	return true;
}

/* The lens of dome cinemas: the polynomial is its radial distortion. The film's frame shows the
 * disc down to 45 degrees below the horizon, and is as wide as the disc when it is not too narrow;
 * measured. */
static bool project_omnimax(const Camera *camera, const ImagePoint *at, Ray *ray)
{
	const double frame = 0.77914; /* half of 1 + the radius that sees 45 degrees */
	double aspect = vec3_length(camera->right) / vec3_length(camera->up);
	double height = fmax(1 / aspect, frame);
	ImagePoint disc = *at;
	disc.x = 2 * at->x * fmax(aspect * frame, 1);
	disc.y = 2 * at->y * height + (aspect > 1 ? 1 - height : 0);
	double radius = hypot(disc.x, disc.y), r2 = radius * radius;
	double theta = radius * (1.411269 - 0.09439 * r2 + 0.25674 * r2 * r2);
	ray->direction = polar_direction(camera, &disc, radius, theta);
	double rise = radius > 0 ? sin(theta) * disc.y / radius : 0;
	return radius <= 1 && rise + cos(theta) >= 0;
}

/* An upright cylinder around the eye, half a turn wide, the height of the image all of it; no angle
 * counts. */
static bool project_panoramic(const Camera *camera, const ImagePoint *at, Ray *ray)
{
	ray->direction = combine(camera->right, sin(PI * at->x), camera->up, tan(PI * at->y),
	                         camera->direction, cos(PI * at->x));
	return true;
}

static bool project_spherical(const Camera *camera, const ImagePoint *at, Ray *ray)
{
	double x = at->x * radians(camera->h_angle), y = at->y * radians(camera->v_angle);
	ray->direction = combine(vec3_normalize(camera->right), cos(y) * sin(x),
				 vec3_normalize(camera->up), sin(y),
				 vec3_normalize(camera->direction), cos(y) * cos(x));
	return true;
}

/* 1 and 3 wrap the image around an upright cylinder, 2 and 4 around a lying one; in 3 and 4 the eye
 * moves along the axis. */
static bool project_cylinder(const Camera *camera, const ImagePoint *at, Ray *ray)
{
	bool upright = camera->cylinder == 1 || camera->cylinder == 3;
	double turn = (upright ? at->x : at->y) * radians(camera->angle > 0 ? camera->angle : 180);
	double along = upright ? at->y : at->x;
	Vec3 across = vec3_normalize(upright ? camera->right : camera->up);
	Vec3 axis = upright ? camera->up : camera->right;
	ray->direction = combine(across, sin(turn), axis, 0, vec3_normalize(camera->direction),
				 cos(turn));
	if (camera->cylinder <= 2)
		ray->direction = vec3_mad(ray->direction, along, axis);
	else
		ray->origin = vec3_mad(ray->origin, along, axis);
	return true;
}

static Projection *const projections[] = {
	[CAMERA_PERSPECTIVE] = project_perspective,
	[CAMERA_ORTHOGRAPHIC] = project_orthographic,
	[CAMERA_FISHEYE] = project_fisheye,
	[CAMERA_ULTRA_WIDE] = project_ultra_wide,
	[CAMERA_OMNIMAX] = project_omnimax,
	[CAMERA_PANORAMIC] = project_panoramic,
	[CAMERA_SPHERICAL] = project_spherical,
	[CAMERA_CYLINDER] = project_cylinder,
};

/* The unit square to the unit disc, keeping areas (Shirley & Chiu 1997). */
static Vec2 disc_point(Vec2 square)
{
	double a = 2 * square.u - 1, b = 2 * square.v - 1;
	if (a == 0 && b == 0)
		return (Vec2){0, 0};
	bool wide = fabs(a) > fabs(b);
	double radius = wide ? a : b;
	double angle = wide ? PI / 4 * b / a : PI / 2 - PI / 4 * a / b;
	return (Vec2){radius * cos(angle), radius * sin(angle)};
}

/* Moves the ray's start within the aperture; it goes on through the same point of the plane in
 * focus. The lens is half as wide as `aperture` says: so it is in POV-Ray, measured. */
static void focus_ray(const Camera *camera, Vec2 lens, Ray *ray)
{
	Vec2 disc = disc_point(lens);
	Vec3 view = vec3_normalize(camera->direction);
	double distance = camera->focal_distance;
	if (camera->has_focal_point)
		distance = vec3_dot(vec3_sub(camera->focal_point, camera->location), view);
	double along = vec3_dot(ray->direction, view);
	Vec3 focus = vec3_mad(ray->origin, distance / (along != 0 ? along : 1), ray->direction);
	double radius = camera->aperture / 4;
	ray->origin = combine(vec3_normalize(camera->right), disc.u * radius,
			      vec3_normalize(camera->up), disc.v * radius, ray->origin, 1);
	ray->direction = vec3_sub(focus, ray->origin);
}

static void perturb_ray(const Camera *camera, const ImagePoint *at, Ray *ray)
{
	SurfacePoint point = {
		.p = {at->x, at->y, 0}, .world = {at->x, at->y, 0},
		.normal = ray->direction, .direction = ray->direction,
	};
	ray->direction = normal_perturb(camera->normal, &point, ray->direction);
}

bool camera_ray(const Camera *camera, double x, double y, int width, int height, Vec2 lens,
		Ray *out)
{
	ImagePoint at = {x / width - 0.5, 0.5 - y / height, width, height};
	*out = (Ray){.origin = camera->location, .tmin = 0, .tmax = INFINITY};
	if (camera->kind == CAMERA_MESH)
		return mesh_camera_ray(camera->mesh, 0, (Vec2){x, y}, (const int[]){width, height},
				       out);
	if (!projections[camera->kind](camera, &at, out))
		return false;
	if (camera->normal) {
		out->direction = vec3_normalize(out->direction);
		perturb_ray(camera, &at, out);
	}
	if (camera->aperture > 0 && (camera->focal_distance > 0 || camera->has_focal_point))
		focus_ray(camera, lens, out);
	out->direction = vec3_normalize(out->direction);
	return true;
}
