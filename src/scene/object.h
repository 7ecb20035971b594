/*
 * Objects as the language builds them: a tree whose nodes carry a transform to the enclosing space,
 * a texture, an interior and flags. Nodes are immutable once a name or a parent refers to them;
 * `object { Name ... }` copies one node and shares its children. scene_flatten turns the tree into
 * geom shapes in world space whose owner is a Surface.
 */
#ifndef SCENE_OBJECT_H
#define SCENE_OBJECT_H

#include "base/arena.h"
#include "geom/shape.h"
#include "light/light.h"
#include "scene/photon_settings.h"
#include "surface/texture.h"

typedef enum ObjectKind {
	OBJECT_PRIMITIVE,
	OBJECT_UNION,
	OBJECT_INTERSECTION,
	OBJECT_DIFFERENCE,
	OBJECT_MERGE,
	OBJECT_LIGHT,       /* light_source, perhaps with looks_like as its one child */
	OBJECT_LIGHT_GROUP, /* children: lights and the objects they alone light */
} ObjectKind;

typedef enum Tristate { UNSET = -1, OFF = 0, ON = 1 } Tristate;

typedef struct ObjectFlags {
	Tristate hollow, no_shadow, no_image, no_reflection, no_radiosity, double_illuminate,
		uv_mapping;
	Tristate cutaway_textures, split_union, global_lights;
	Tristate photons_target, photons_refraction, photons_reflection, photons_collect,
		photons_pass_through;
	Tristate relaxation;
} ObjectFlags;

enum { OBJECT_DEPTH_MAX = 2000 };

typedef struct Object Object;
struct Object {
	ObjectKind kind;
	const ShapeClass *class;          /* PRIMITIVE */
	const void *data;                 /* PRIMITIVE: the class' data */
	const Light *light;               /* LIGHT, in this object's own space */
	const Object *const *children; int child_count;
	int depth; /* levels of children below; at most OBJECT_DEPTH_MAX, flattening recurses */
	Transform transform;              /* own space to the enclosing one */
	const Texture *texture;           /* NULL: the enclosing object's, at last the default */
	bool texture_is_default;          /* nobody gave it one */
	const Texture *interior_texture;
	const Texture *const *textures;
	int texture_count; /* numbered ones: texture_list of meshes, blob components */
	Transform texture_transform; /* transforms given after the texture: texture's space to the
					enclosing one */
	const Interior *interior;         /* NULL: the enclosing object's */
	bool inverse;
	ObjectFlags flags;
	const Object *const *clip; int clip_count;
	const Object *const *bound; int bound_count;
	bool clip_is_bound;               /* bounded_by { clipped_by } or the other way round */
	const Object *projected_through;  /* LIGHT; or NULL */
	double photon_spacing;            /* photons { target X }; 0: unset */
	const Estimator *estimator;       /* photons { estimator }; or NULL */
};

/* cutaway_textures: parts of a CSG. A face without a texture shows those of the parts that it cuts:
 * the mean of all whose insides hold the place. */
typedef struct Cutaway {
	const Shape *const *parts;
	int count;
} Cutaway;

/* What a primitive's owner points to. */
typedef struct Surface {
	const Texture *texture;          /* never NULL */
	bool textured;                   /* by the scene, not by default */
	const Cutaway *cutaway;          /* or NULL */
	const Texture *interior_texture; /* or NULL */
	const Texture *const *textures;
	int texture_count; /* what the class' textures() numbers; an entry may be NULL */
	const Transform *attach;         /* from the texture's space to the world; NULL: none */
	const Transform *numbered_attach; /* the same for textures[] */
	const Interior *interior;        /* or NULL */
	bool hollow, no_shadow, no_image, no_reflection, no_radiosity, double_illuminate,
		uv_mapping;
	bool global_lights;
	int light_group;                 /* 0: none */
	bool photons_target, photons_refraction, photons_reflection, photons_collect,
		photons_pass_through;
	double photon_spacing;
	const Estimator *estimator;      /* NULL: the scene's */
	bool relaxation;                 /* photons that land here may be relaxed */
	bool opaque; /* no texture of it lets light through: shadow rays need not look closer */
	bool ends_light; /* nor does any reflect, and all of them scatter: photons go no farther */
	bool uniform; /* textured the same everywhere, on both sides, by one layer without bumps */
	int id;                          /* of the top-level object, counting from 0 */
} Surface;

Object object_default(ObjectKind kind);
/* The object with a further transformation: its texture, clips, bounds and what a light projects
 * through move along. Copies what it changes into the arena. */
void object_transform(Arena *arena, Object *object, const Transform *transform);

#endif
