/* Cameras: where eye rays start for a point of the image. */
#ifndef SCENE_CAMERA_H
#define SCENE_CAMERA_H

#include "base/vec.h"
#include "geom/shape.h"
#include "scene/mesh_camera.h"
#include "surface/texture.h"

typedef enum CameraKind {
	CAMERA_PERSPECTIVE,
	CAMERA_ORTHOGRAPHIC,
	CAMERA_FISHEYE,
	CAMERA_ULTRA_WIDE,
	CAMERA_OMNIMAX,
	CAMERA_PANORAMIC,
	CAMERA_SPHERICAL,
	CAMERA_CYLINDER,
	CAMERA_MESH
} CameraKind;

typedef struct Camera {
	CameraKind kind;
	int cylinder;                      /* 1..4 */
	Vec3 location, direction, right, up; /* right and up span the whole image; lengths count */
	Vec3 sky;
	double angle;                      /* degrees, horizontal; 0: from direction and right */
	double h_angle, v_angle;           /* spherical: degrees */
	const Normal *normal;              /* perturbs rays; or NULL */
	double aperture, focal_distance;   /* focal blur, as the scene says; aperture 0:
					      none, else four times the lens' radius */
	Vec3 focal_point; bool has_focal_point;
	int blur_samples_min, blur_samples;
	double confidence, variance;
	const char *bokeh;                 /* reserved */
	const Pigment *bokeh_pigment;      /* or NULL */
	const MeshCamera *mesh;            /* CAMERA_MESH; its rays count, nothing above */
} Camera;

Camera camera_default(double aspect);

/* The eye ray through the image point (x, y) in pixels (0,0 the upper left corner; pixel centres at
 * halves) of a width x height image; lens is a point of the unit square for focal blur, {0.5, 0.5}
 * the pinhole. False where the camera sees nothing (outside a fisheye's circle). */
bool camera_ray(const Camera *camera, double x, double y, int width, int height, Vec2 lens,
		Ray *out);

#endif
