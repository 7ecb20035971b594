/*
 * The scene: everything the renderer knows, immutable after scene_freeze. lang fills in a
 * SceneBuilder; freezing flattens objects, inherits textures, collects lights and builds the
 * accelerator.
 */
#ifndef SCENE_SCENE_H
#define SCENE_SCENE_H

#include "base/arena.h"
#include "base/color.h"
#include "base/diag.h"
#include "scene/camera.h"
#include "scene/object.h"
#include "scene/photon_settings.h"
#include "surface/noise.h"
#include "surface/texture.h"

typedef enum FogKind { FOG_CONSTANT = 1, FOG_GROUND = 2 } FogKind;

typedef struct Fog {
	FogKind kind;
	Rgbft color;
	double distance;         /* over which it leaves 1/e; 0: no fog */
	double offset, alt;      /* ground fog: even up to offset along up, thinner by alt above */
	Vec3 up;                 /* unit */
	Turbulence turbulence;   /* no amount: none */
	double turb_depth;       /* how much of the depth that takes */
} Fog;

typedef struct Rainbow {
	Vec3 direction, up, antisolar;
	double angle, width, distance, jitter, arc_angle, falloff_angle;
	const Pigment *pigment; /* colours along the rainbow, a gradient on x */
} Rainbow;

typedef struct SkySphere {
	const Pigment *const *pigments; int count; /* bottom to top */
	Transform transform;
	Rgb emission;                              /* 1 */
} SkySphere;

typedef struct Settings {
	double adc_bailout;      /* 1/255 */
	Rgb ambient_light;       /* 1 */
	double assumed_gamma;    /* 0: not given; -1: srgb */
	int max_trace_level;     /* 5 */
	int max_intersections;
	int number_of_waves;     /* 10 */
	int noise_generator;     /* 2 */
	Rgb irid_wavelength;     /* 0.70 0.52 0.48 as measured; the manual is outdated */
	double mm_per_unit;
	PhotonSettings photons;
	bool has_radiosity;      /* the scene asks for it */
	double version;          /* 3.7 */
	bool cognac;             /* #version unofficial cognac */
} Settings;

Settings settings_default(void);

typedef struct SceneBuilder {
	Arena *arena;            /* the scene's own: lives as long as the scene */
	Diag *diag;
	Settings settings;
	Camera camera; bool has_camera;
	Rgbft background; bool has_background;
	const Object **objects; int object_count; /* top level, lights among them */
	const Fog **fogs; int fog_count;
	const Rainbow **rainbows; int rainbow_count;
	const SkySphere *sky_sphere;
	const Interior *atmosphere; /* top-level media; reserved */
} SceneBuilder;

/* What is added must live in the builder's arena. */
void scene_builder_add_object(SceneBuilder *builder, const Object *object);
void scene_builder_add_fog(SceneBuilder *builder, const Fog *fog);
void scene_builder_add_rainbow(SceneBuilder *builder, const Rainbow *rainbow);

typedef struct Accel Accel; /* scene/accel.h */

typedef struct Scene {
	Arena *arena;
	Settings settings;
	Camera camera;
	Rgbft background;
	const Shape *const *shapes;
	int shape_count; /* every one a primitive or a CSG, in world space */
	bool hides_from_image, hides_from_reflection; /* some surface: no_image, no_reflection */
	const Light *lights; int light_count;
	const Fog *const *fogs; int fog_count;
	const Rainbow *const *rainbows; int rainbow_count;
	const SkySphere *sky_sphere;
	Accel *accel;
} Scene;

/* Takes over the builder's arena. NULL on failure, reported. */
Scene *scene_freeze(SceneBuilder *builder);
void scene_destroy(Scene *scene);

#endif
