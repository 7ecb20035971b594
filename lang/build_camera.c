#include "lang/build_camera.h"

#include <math.h>

#include "lang/build_object.h"
#include "lang/build_texture.h"
#include "lang/build_transform.h"
#include "lang/cursor.h"

static const double PI = 3.14159265358979323846;

typedef struct CameraReading {
	Camera camera;
	Transform transform;
	Vec3 look_at, focal_point;
	MeshCamera *mesh; /* mesh_camera; or NULL */
	bool smooth;
	bool has_look_at, has_size, has_angle, has_focal_point; /* size: up or right */
} CameraReading;

static bool accept_kind(Cursor *cursor, Camera *camera)
{
	static const struct {
		Word word;
		CameraKind kind;
	} rows[] = {
		{W_perspective, CAMERA_PERSPECTIVE}, {W_orthographic, CAMERA_ORTHOGRAPHIC},
		{W_fisheye, CAMERA_FISHEYE},         {W_ultra_wide_angle, CAMERA_ULTRA_WIDE},
		{W_omnimax, CAMERA_OMNIMAX},         {W_panoramic, CAMERA_PANORAMIC},
		{W_spherical, CAMERA_SPHERICAL},
	};
	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
		if (cursor_accept_word(cursor, rows[i].word)) {
			camera->kind = rows[i].kind;
			return true;
		}
	if (!cursor_accept_word(cursor, W_cylinder))
		return false;
	camera->kind = CAMERA_CYLINDER;
	if (cursor_take_int(cursor, &camera->cylinder) &&
	    (camera->cylinder < 1 || camera->cylinder > 4))
		diag_error(cursor->context->diag, cursor->last->where,
			   "a cylinder camera's type must be from 1 to 4");
	return true;
}

static bool accept_vector(Cursor *cursor, CameraReading *reading)
{
	Camera *camera = &reading->camera;
	if (cursor_accept_word(cursor, W_location))
		cursor_take_vec3(cursor, &camera->location);
	else if (cursor_accept_word(cursor, W_direction))
		cursor_take_vec3(cursor, &camera->direction);
	else if (cursor_accept_word(cursor, W_right))
		reading->has_size |= cursor_take_vec3(cursor, &camera->right);
	else if (cursor_accept_word(cursor, W_up))
		reading->has_size |= cursor_take_vec3(cursor, &camera->up);
	else if (cursor_accept_word(cursor, W_sky))
		cursor_take_vec3(cursor, &camera->sky);
	else if (cursor_accept_word(cursor, W_look_at))
		reading->has_look_at |= cursor_take_vec3(cursor, &reading->look_at);
	else if (cursor_accept_word(cursor, W_focal_point))
		reading->has_focal_point |= cursor_take_vec3(cursor, &reading->focal_point);
	else
		return false;
	return true;
}

/* angle horizontal [vertical]; without a number it only asks an orthographic camera for a
 * perspective one's width. */
static void read_angle(Cursor *cursor, CameraReading *reading)
{
	Camera *camera = &reading->camera;
	reading->has_angle = true;
	camera->angle = cursor_optional_float(cursor, 0);
	if (camera->angle < 0 || (camera->kind == CAMERA_PERSPECTIVE && camera->angle >= 180)) {
		diag_error(cursor->context->diag, cursor->last->where,
			   "a viewing angle of %g degrees", camera->angle);
		camera->angle = 0;
	}
	if (camera->angle > 0) {
		camera->h_angle = camera->angle;
		camera->v_angle = camera->angle / 2;
	}
	camera->v_angle = cursor_optional_float(cursor, camera->v_angle);
}

/* blur_samples [least,] most */
static void read_samples(Cursor *cursor, Camera *camera)
{
	if (!cursor_take_int(cursor, &camera->blur_samples) || !cursor_peek_float(cursor))
		return;
	camera->blur_samples_min = camera->blur_samples;
	cursor_take_int(cursor, &camera->blur_samples);
}

static bool accept_blur(Cursor *cursor, CameraReading *reading)
{
	Camera *camera = &reading->camera;
	const Node *block;
	if (cursor_accept_word(cursor, W_aperture)) {
		cursor_take_float(cursor, &camera->aperture);
	} else if (cursor_accept_word(cursor, W_blur_samples)) {
		read_samples(cursor, camera);
	} else if (cursor_accept_word(cursor, W_confidence)) {
		cursor_take_float(cursor, &camera->confidence);
	} else if (cursor_accept_word(cursor, W_variance)) {
		cursor_take_float(cursor, &camera->variance);
	} else if ((block = cursor_accept_block(cursor, W_bokeh))) {
		Cursor inside = cursor_begin(cursor->context, block);
		const Node *pigment = cursor_accept_block(&inside, W_pigment);
		if (pigment)
			camera->bokeh_pigment = build_pigment(cursor->context, pigment,
							      cursor->context->defaults.pigment);
		else
			cursor_expected(&inside, "a pigment");
		cursor_end(&inside);
	} else {
		return false;
	}
	return true;
}

/* The meshes, in the order of their rays. */
static void read_camera_meshes(Cursor *cursor, MeshCamera *camera)
{
	Arena *arena = cursor->context->builder->arena;
	ObjectList list = {0};
	build_object_list(cursor, &list);
	MeshCameraPart *parts = ARENA_ARRAY(arena, MeshCameraPart, list.count + 1);
	for (int i = 0; i < list.count; i++) {
		MeshCameraPart *part = &parts[camera->part_count];
		*part = (MeshCameraPart){.mesh = list.items[i]->data,
					 .transform = list.items[i]->transform};
		if (list.items[i]->kind != OBJECT_PRIMITIVE || list.items[i]->class != &mesh_class)
			diag_error(cursor->context->diag, cursor->block->where,
				   "a mesh_camera takes meshes only");
		else if (camera->distribution == 3 && !mesh_camera_index(arena, part))
			diag_error(cursor->context->diag, cursor->block->where,
				   "a mesh_camera of distribution 3 needs uv_vectors");
		else
			camera->part_count++;
	}
	camera->parts = parts;
}

/* mesh_camera { rays, distribution [, max_distance] meshes } */
static void read_mesh_camera(Cursor *outer, const Node *block, CameraReading *reading)
{
	Cursor cursor = cursor_begin(outer->context, block);
	MeshCamera *camera = ARENA_NEW(outer->context->builder->arena, MeshCamera);
	if (!cursor_take_int(&cursor, &camera->rays) ||
	    !cursor_take_int(&cursor, &camera->distribution))
		return;
	camera->max_distance = cursor_optional_float(&cursor, 0);
	if (camera->rays < 1 || camera->distribution < 0 || camera->distribution > 3) {
		diag_error(outer->context->diag, block->where,
			   "a mesh_camera takes at least one ray and a distribution from 0 to 3");
		return;
	}
	read_camera_meshes(&cursor, camera);
	reading->smooth |= cursor_accept_word(&cursor, W_smooth);
	if (camera->part_count == 0 && cursor_at_end(&cursor))
		diag_error(outer->context->diag, block->where, "a mesh_camera needs a mesh");
	if (cursor_end(&cursor) && camera->part_count > 0) {
		reading->mesh = camera;
		reading->camera.kind = CAMERA_MESH;
	}
}

static bool accept_other(Cursor *cursor, CameraReading *reading)
{
	const Node *block;
	if ((block = cursor_accept_block(cursor, W_normal)))
		reading->camera.normal = build_normal(cursor->context, block,
						      reading->camera.normal);
	else if ((block = cursor_accept_block(cursor, W_mesh_camera)))
		read_mesh_camera(cursor, block, reading);
	else if (cursor_accept_word(cursor, W_angle))
		read_angle(cursor, reading);
	else if (cursor_accept_word(cursor, W_smooth))
		reading->smooth = true;
	else
		return false;
	return true;
}

/* Turns the frame towards look_at; its lengths and its handedness stay. */
static void look_at(CameraReading *reading)
{
	Camera *camera = &reading->camera;
	double right = vec3_length(camera->right), up = vec3_length(camera->up);
	double depth = vec3_length(camera->direction);
	double handedness = vec3_dot(vec3_cross(camera->up, camera->direction), camera->right);
	Vec3 view = vec3_normalize(vec3_sub(reading->look_at, camera->location));
	Vec3 across = vec3_cross(camera->sky, view);
	if (vec3_length2(view) == 0)
		return;
	if (vec3_length(across) < 1e-9 * vec3_length(camera->sky))
		across = vec3_cross(fabs(view.z) < 0.9 ? vec3(0, 0, 1) : vec3(0, 1, 0), view);
	across = vec3_normalize(across);
	camera->direction = vec3_scale(view, depth);
	camera->up = vec3_scale(vec3_cross(view, across), up);
	camera->right = vec3_scale(across, handedness > 0 ? right : -right);
}

/* Without a size of its own, or with an angle, an orthographic camera sees at look_at what a
 * perspective one would. */
static void size_orthographic(CameraReading *reading)
{
	Camera *camera = &reading->camera;
	if (reading->has_size && !reading->has_angle)
		return;
	Vec3 target = reading->has_look_at ? reading->look_at : vec3(0, 0, 1);
	double scale = vec3_distance(target, camera->location) / vec3_length(camera->direction);
	camera->right = vec3_scale(camera->right, scale);
	camera->up = vec3_scale(camera->up, scale);
}

static void apply_angle(Camera *camera)
{
	double length = 0.5 * vec3_length(camera->right) / tan(camera->angle * PI / 360);
	camera->direction = vec3_scale(vec3_normalize(camera->direction), length);
	camera->angle = 0;
}

/* Of location and direction a mesh camera takes the z alone: along the faces' normals. */
static void finish_mesh_camera(CameraReading *reading)
{
	MeshCamera *mesh = reading->mesh;
	mesh->offset = reading->camera.location.z;
	mesh->reversed = reading->camera.direction.z < 0;
	mesh->smooth = reading->smooth;
	reading->camera.mesh = mesh;
}

static void finish_camera(Context *context, CameraReading *reading, const Node *block)
{
	Camera *camera = &reading->camera;
	if (camera->kind == CAMERA_MESH && reading->mesh) {
		finish_mesh_camera(reading);
		return;
	}
	if (vec3_length2(camera->direction) == 0 || vec3_length2(camera->right) == 0 ||
	    vec3_length2(camera->up) == 0) {
		diag_error(context->diag, block->where,
			   "a camera's direction, right and up must not be zero");
		*camera = *context->defaults.camera;
		return;
	}
	bool flat = camera->kind == CAMERA_PERSPECTIVE || camera->kind == CAMERA_ORTHOGRAPHIC;
	if (flat && camera->angle > 0)
		apply_angle(camera);
	if (camera->kind == CAMERA_ORTHOGRAPHIC)
		size_orthographic(reading);
	if (reading->has_look_at)
		look_at(reading);
	if (reading->has_focal_point)
		camera->focal_distance = vec3_distance(reading->focal_point, camera->location);
	camera->location = transform_point(&reading->transform, camera->location);
	camera->direction = transform_vector(&reading->transform, camera->direction);
	camera->right = transform_vector(&reading->transform, camera->right);
	camera->up = transform_vector(&reading->transform, camera->up);
}

/* A named camera takes transformations only. */
static void move_camera(Cursor *cursor, Camera *camera, const Camera *named)
{
	Transform transform = transform_identity();
	while (!cursor_at_end(cursor))
		if (!build_accept_transform(cursor, &transform))
			cursor_unexpected(cursor);
	*camera = *named;
	camera->location = transform_point(&transform, camera->location);
	camera->direction = transform_vector(&transform, camera->direction);
	camera->right = transform_vector(&transform, camera->right);
	camera->up = transform_vector(&transform, camera->up);
}

const Camera *build_camera(Context *context, const Node *block, const Camera *base)
{
	CameraReading reading = {.camera = *base, .transform = transform_identity()};
	Cursor cursor = cursor_begin(context, block);
	const Camera *named = cursor_accept_item(&cursor, VALUE_CAMERA);
	if (named) {
		move_camera(&cursor, &reading.camera, named);
		return arena_copy(context->builder->arena, &reading.camera, sizeof reading.camera);
	}
	while (!cursor_at_end(&cursor))
		if (!build_accept_transform(&cursor, &reading.transform) &&
		    !accept_kind(&cursor, &reading.camera) && !accept_vector(&cursor, &reading) &&
		    !accept_blur(&cursor, &reading) && !accept_other(&cursor, &reading))
			cursor_unexpected(&cursor);
	finish_camera(context, &reading, block);
	return arena_copy(context->builder->arena, &reading.camera, sizeof reading.camera);
}
