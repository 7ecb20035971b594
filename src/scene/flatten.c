#include "scene/flatten.h"

#include <stdlib.h>
#include <string.h>

#include "geom/csg.h"

/* A growing list of pointers; the finished one is copied into the arena. */
typedef struct List {
	const void **items;
	int count, capacity;
} List;

static void list_push(List *list, const void *item)
{
	if (list->count == list->capacity) {
		list->capacity = list->capacity ? 2 * list->capacity : 16;
		list->items = memory_resize(list->items,
					    (size_t)list->capacity * sizeof *list->items);
	}
	list->items[list->count++] = item;
}

static const void *list_finish(List *list, Arena *arena)
{
	if (!list->count)
		return NULL;
	const void *copy = arena_copy(arena, list->items,
				      (size_t)list->count * sizeof *list->items);
	free(list->items);
	return copy;
}

/* What an object hands down to its children. */
typedef struct State {
	Transform world;        /* the space of the children to the world */
	Surface surface;
	const Surface *made;    /* the surface in the arena, once a primitive needed it */
	bool inverted;
	bool part;              /* inside a CSG */
	const Shape *const *clip; int clip_count;
	const Shape *const *bound; int bound_count;
} State;

typedef struct Flatten {
	Arena *arena;
	bool surfaces; /* false: shapes alone, without owners and lights */
	List lights;
	int group_count;
	bool hides_from_image, hides_from_reflection;
} Flatten;

static void emit(Flatten *flatten, const Object *object, State *parent, List *out);

static void inherit_flag(bool *flag, Tristate own)
{
	if (own != UNSET)
		*flag = own == ON;
}

static const Transform *keep_transform(Arena *arena, const Transform *transform)
{
	return transform_is_identity(transform) ? NULL
						: arena_copy(arena, transform, sizeof *transform);
}

static void inherit_flags(Surface *surface, const ObjectFlags *flags)
{
	inherit_flag(&surface->hollow, flags->hollow);
	inherit_flag(&surface->no_shadow, flags->no_shadow);
	inherit_flag(&surface->no_image, flags->no_image);
	inherit_flag(&surface->no_reflection, flags->no_reflection);
	inherit_flag(&surface->no_radiosity, flags->no_radiosity);
	inherit_flag(&surface->double_illuminate, flags->double_illuminate);
	inherit_flag(&surface->uv_mapping, flags->uv_mapping);
	inherit_flag(&surface->photons_target, flags->photons_target);
	inherit_flag(&surface->photons_refraction, flags->photons_refraction);
	inherit_flag(&surface->photons_reflection, flags->photons_reflection);
	inherit_flag(&surface->photons_collect, flags->photons_collect);
	/* What throws no shadow lets photons pass, unless it is told not to. */
	inherit_flag(&surface->photons_pass_through,
		     flags->photons_pass_through == UNSET ? flags->no_shadow
							  : flags->photons_pass_through);
	inherit_flag(&surface->relaxation, flags->relaxation);
}

/* The surface of an object's primitives, from its parent's. */
static Surface inherit_surface(Arena *arena, const Object *object, const State *parent)
{
	Surface surface = parent->surface;
	if (object->texture) {
		Transform attach = transform_compose(&object->texture_transform, &parent->world);
		surface.texture = object->texture;
		surface.textured = !object->texture_is_default;
		surface.cutaway = NULL;
		surface.attach = keep_transform(arena, &attach);
		surface.interior_texture = NULL;
	}
	if (object->interior_texture)
		surface.interior_texture = object->interior_texture;
	if (object->interior)
		surface.interior = object->interior;
	else if (object->texture && !surface.interior)
		surface.interior = texture_interior(object->texture);
	if (object->photon_spacing > 0)
		surface.photon_spacing = object->photon_spacing;
	if (object->estimator)
		surface.estimator = object->estimator;
	inherit_flags(&surface, &object->flags);
	return surface;
}

/* Whether it holds for each texture that the surface may show; those of what it cuts away are not
 * known yet. */
static bool holds_for_all(const Surface *surface, bool (*holds)(const Texture *texture))
{
	if (surface->cutaway || !holds(surface->texture))
		return false;
	if (surface->interior_texture && !holds(surface->interior_texture))
		return false;
	for (int i = 0; i < surface->texture_count; i++)
		if (surface->textures[i] && !holds(surface->textures[i]))
			return false;
	return true;
}

/* uv_mapping of the object lays its textures out over (u, v); from here on the flag says that some
 * texture needs these. */
static void apply_uv_mapping(Arena *arena, Surface *surface)
{
	bool whole = surface->uv_mapping;
	if (whole) {
		surface->texture = texture_by_uv(arena, surface->texture);
		if (surface->interior_texture)
			surface->interior_texture = texture_by_uv(arena, surface->interior_texture);
	}
	surface->uv_mapping = whole || texture_uses_uv(surface->texture) ||
		(surface->interior_texture && texture_uses_uv(surface->interior_texture));
	if (!surface->texture_count)
		return;
	const Texture **textures = ARENA_ARRAY(arena, const Texture *, surface->texture_count);
	for (int i = 0; i < surface->texture_count; i++) {
		const Texture *texture = surface->textures[i];
		textures[i] = whole && texture ? texture_by_uv(arena, texture) : texture;
		surface->uv_mapping = surface->uv_mapping || (texture && texture_uses_uv(texture));
	}
	surface->textures = textures;
}

static const Surface *keep_surface(Flatten *flatten, State *state)
{
	if (!state->made) {
		Surface surface = state->surface;
		apply_uv_mapping(flatten->arena, &surface);
		surface.opaque = holds_for_all(&surface, texture_is_opaque);
		surface.ends_light = surface.opaque && holds_for_all(&surface, texture_is_dull);
		surface.uniform = texture_is_uniform(surface.texture) && !surface.cutaway &&
				  !surface.interior_texture && !surface.texture_count;
		flatten->hides_from_image |= surface.no_image;
		flatten->hides_from_reflection |= surface.no_reflection;
		state->made = arena_copy(flatten->arena, &surface, sizeof surface);
	}
	return state->made;
}

static bool shares_surface(const Object *object)
{
	const ObjectFlags none = object_default(OBJECT_UNION).flags;
	return !object->texture && !object->interior_texture && !object->interior &&
	       !object->texture_count && !object->estimator && object->photon_spacing == 0 &&
	       memcmp(&object->flags, &none, sizeof none) == 0;
}

static Shape *new_shape(Flatten *flatten, const ShapeClass *class, const void *data)
{
	Shape *shape = ARENA_NEW(flatten->arena, Shape);
	shape->class = class;
	shape->data = data;
	return shape;
}

/* The last step for a shape: clips, bounds where they are needed, the box. */
static const Shape *finish_shape(Shape *shape, const State *state)
{
	shape->clip = state->clip;
	shape->clip_count = state->clip_count;
	shape_finish(shape);
	if (state->bound_count && !shape_is_bounded(shape)) {
		shape->bound = state->bound;
		shape->bound_count = state->bound_count;
		shape_finish(shape);
	}
	return shape;
}

/* Into the data when the class knows how, else beside them. */
static void place_shape(Flatten *flatten, Shape *shape, const Transform *world)
{
	const ShapeClass *class = shape->class;
	if (transform_is_identity(world))
		return;
	const void *placed = class->placed ? class->placed(flatten->arena, shape->data, world)
					   : NULL;
	if (placed)
		shape->data = placed;
	else
		shape->transform = arena_copy(flatten->arena, world, sizeof *world);
}

static void emit_primitive(Flatten *flatten, const Object *object, State *state, List *out)
{
	Shape *shape = new_shape(flatten, object->class, object->data);
	place_shape(flatten, shape, &state->world);
	shape->inverted = state->inverted;
	shape->part = state->part;
	if (flatten->surfaces) {
		if (object->texture_count) {
			state->surface.textures = object->textures;
			state->surface.texture_count = object->texture_count;
			state->surface.numbered_attach = keep_transform(flatten->arena,
									&state->world);
		}
		shape->owner = keep_surface(flatten, state);
	}
	list_push(out, finish_shape(shape, state));
}

/* One shape for an object that may be several. */
static const Shape *single_shape(Flatten *flatten, const Object *object, State *parent)
{
	List members = {0};
	emit(flatten, object, parent, &members);
	if (members.count == 1) {
		const Shape *only = members.items[0];
		free(members.items);
		return only;
	}
	const Csg *csg = csg_create(flatten->arena, list_finish(&members, flatten->arena),
				    members.count);
	Shape *shape = new_shape(flatten, &csg_union_class, csg);
	shape_finish(shape);
	return shape;
}

/* Lights are collected from everywhere but are no shape. */
static bool has_shape(const Object *object)
{
	return object->kind != OBJECT_LIGHT || object->child_count > 0;
}

/* For its untextured primitives, not for those of a CSG within; NULL when not asked for, or when
 * all have a texture from further out. The parts are filled in later. */
static Cutaway *begin_cutaway(Flatten *flatten, const Object *object, const State *state)
{
	bool wanted = object->flags.cutaway_textures == ON && flatten->surfaces &&
		      !state->surface.textured &&
		      (object->kind == OBJECT_DIFFERENCE || object->kind == OBJECT_INTERSECTION);
	return wanted ? ARENA_NEW(flatten->arena, Cutaway) : NULL;
}

static void set_cutaway(State *state, const Cutaway *cutaway)
{
	if (state->surface.cutaway == cutaway)
		return;
	state->surface.cutaway = cutaway;
	state->made = NULL;
}

static void emit_csg(Flatten *flatten, const Object *object, State *state, List *out)
{
	bool outward = object->kind == OBJECT_UNION || object->kind == OBJECT_MERGE;
	const ShapeClass *class = outward == state->inverted ? &csg_intersection_class
							     : &csg_merge_class;
	State inner = *state;
	List members = {0};
	Cutaway *cutaway = begin_cutaway(flatten, object, state);
	inner.clip_count = inner.bound_count = 0;
	inner.part = true;
	for (int i = 0; i < object->child_count; i++) {
		bool primitive = object->children[i]->kind == OBJECT_PRIMITIVE;
		set_cutaway(&inner, primitive ? cutaway : NULL);
		inner.inverted = state->inverted != (object->kind == OBJECT_DIFFERENCE && i > 0);
		const Shape *member = single_shape(flatten, object->children[i], &inner);
		if (has_shape(object->children[i]))
			list_push(&members, member);
	}
	int count = members.count;
	const Shape *const *parts = list_finish(&members, flatten->arena);
	if (cutaway)
		*cutaway = (Cutaway){parts, count > 1 && object->kind == OBJECT_DIFFERENCE ? 1
											   : count};
	list_push(out, finish_shape(new_shape(flatten, class,
					      csg_create(flatten->arena, parts, count)),
				    state));
}

static void emit_children(Flatten *flatten, const Object *object, State *state, List *out)
{
	for (int i = 0; i < object->child_count; i++)
		emit(flatten, object->children[i], state, out);
}

static Light *place_light(Flatten *flatten, const Object *object, const State *state)
{
	Light *light = arena_copy(flatten->arena, object->light, sizeof *light);
	light->position = transform_point(&state->world, light->position);
	light->point_at = transform_point(&state->world, light->point_at);
	light->axis1 = transform_vector(&state->world, light->axis1);
	light->axis2 = transform_vector(&state->world, light->axis2);
	light->group = state->surface.light_group;
	return light;
}

static void emit_light(Flatten *flatten, const Object *object, State *state, List *out)
{
	if (flatten->surfaces) {
		Light *light = place_light(flatten, object, state);
		list_push(&flatten->lights, light);
		if (object->projected_through) {
			State outer = *state;
			Transform back = transform_inverse(&object->transform);
			outer.world = transform_compose(&back, &state->world);
			Flatten shapes = {.arena = flatten->arena};
			light->projected_through = single_shape(&shapes, object->projected_through,
								&outer);
		}
		state->surface.no_shadow = true;
		state->made = NULL;
	}
	emit_children(flatten, object, state, out);
}

/* In groups of groups the outermost says whether the scene's other lights reach in. */
static void emit_group(Flatten *flatten, const Object *object, State *state, List *out)
{
	if (state->surface.light_group == 0)
		state->surface.global_lights = object->flags.global_lights == ON;
	state->surface.light_group = ++flatten->group_count;
	state->made = NULL;
	emit_children(flatten, object, state, out);
}

/* The parent's clips or bounds and the object's own, which stand in the parent's space. */
static const Shape *const *join_clips(Flatten *flatten, const Shape *const *outer, int *count,
				      const Object *const *own, int own_count,
				      const Transform *world)
{
	if (!own_count)
		return outer;
	const Shape **clips = ARENA_ARRAY(flatten->arena, const Shape *, *count + own_count);
	Flatten shapes = {.arena = flatten->arena};
	State state = {.world = *world};
	for (int i = 0; i < *count; i++)
		clips[i] = outer[i];
	for (int i = 0; i < own_count; i++)
		clips[*count + i] = single_shape(&shapes, own[i], &state);
	*count += own_count;
	return clips;
}

/* The state of an object's inside: its children's, or its own primitive's. */
static State enter(Flatten *flatten, const Object *object, State *parent)
{
	State state = *parent;
	state.world = transform_compose(&object->transform, &parent->world);
	state.inverted = parent->inverted != object->inverse;
	state.clip = join_clips(flatten, parent->clip, &state.clip_count, object->clip,
				object->clip_count, &parent->world);
	state.bound = join_clips(flatten, parent->bound, &state.bound_count, object->bound,
				 object->bound_count, &parent->world);
	if (!flatten->surfaces)
		return state;
	if (shares_surface(object)) {
		state.made = object->kind == OBJECT_PRIMITIVE ? keep_surface(flatten, parent)
							      : parent->made;
	} else {
		state.surface = inherit_surface(flatten->arena, object, parent);
		state.made = NULL;
	}
	return state;
}

static void emit(Flatten *flatten, const Object *object, State *parent, List *out)
{
	State state = enter(flatten, object, parent);
	switch (object->kind) {
	case OBJECT_PRIMITIVE:
		emit_primitive(flatten, object, &state, out);
		break;
	case OBJECT_LIGHT:
		emit_light(flatten, object, &state, out);
		break;
	case OBJECT_LIGHT_GROUP:
		emit_group(flatten, object, &state, out);
		break;
	case OBJECT_UNION:
		if (!state.inverted) {
			emit_children(flatten, object, &state, out);
			break;
		}
		/* fall through */
	default:
		emit_csg(flatten, object, &state, out);
	}
}

/* What a surface is when nobody says otherwise. The texture is black, as POV-Ray's default. */
static Surface surface_default(Arena *arena)
{
	Texture *texture = ARENA_NEW(arena, Texture);
	Pigment *pigment = ARENA_NEW(arena, Pigment);
	Finish *finish = ARENA_NEW(arena, Finish);
	*finish = finish_default();
	texture->pigment = pigment;
	texture->finish = finish;
	return (Surface){.texture = texture,
			 .global_lights = true,
			 .photons_collect = true,
			 .relaxation = true};
}

FlatScene scene_flatten(Arena *arena, const Object *const *objects, int count)
{
	Flatten flatten = {.arena = arena, .surfaces = true};
	List shapes = {0};
	State state = {.world = transform_identity(), .surface = surface_default(arena)};
	for (int i = 0; i < count; i++) {
		state.surface.id = i;
		state.made = NULL;
		emit(&flatten, objects[i], &state, &shapes);
	}
	FlatScene flat = {.shape_count = shapes.count,
			  .light_count = flatten.lights.count,
			  .hides_from_image = flatten.hides_from_image,
			  .hides_from_reflection = flatten.hides_from_reflection};
	Light *lights = ARENA_ARRAY(arena, Light, flat.light_count);
	for (int i = 0; i < flat.light_count; i++)
		lights[i] = *(const Light *)flatten.lights.items[i];
	free(flatten.lights.items);
	flat.lights = lights;
	flat.shapes = list_finish(&shapes, arena);
	return flat;
}

const Shape *object_shape(Arena *arena, const Object *object)
{
	Flatten flatten = {.arena = arena};
	State state = {.world = transform_identity()};
	return single_shape(&flatten, object, &state);
}
