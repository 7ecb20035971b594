/* Shapes from fields and functions: blob, isosurface, parametric, julia_fractal. */
#include "lang/build_object.h"

#include "geom/blob.h"
#include "geom/isosurface.h"
#include "geom/julia_fractal.h"
#include "geom/parametric.h"
#include "lang/build_texture.h"
#include "lang/build_transform.h"
#include "surface/function.h"

static Arena *scene_arena(const Cursor *cursor) { return cursor->context->builder->arena; }

/* A blob being read: components and their textures, in arrays as long as the block has nodes. */
typedef struct BlobReading {
	BlobComponent *components;
	const Texture **textures;
	int count, texture_count;
} BlobReading;

static bool accept_word_strength(Cursor *cursor, double *strength)
{
	cursor_accept_word(cursor, W_strength);
	return cursor_take_float(cursor, strength);
}

/* Textures and transformations of one component: an object of its own for as long as they are read.
 */
static void read_component_modifiers(Cursor *cursor, BlobReading *reading, BlobComponent *component)
{
	Context *context = cursor->context;
	Object part = object_default(OBJECT_PRIMITIVE);
	while (!cursor_at_end(cursor))
		if (!build_object_modifier(cursor, &part))
			cursor_unexpected(cursor);
	component->texture = -1;
	if (!transform_is_identity(&part.transform))
		component->transform = arena_copy(context->builder->arena, &part.transform,
						  sizeof part.transform);
	if (!part.texture)
		return;
	component->texture = reading->texture_count;
	reading->textures[reading->texture_count++] =
		build_texture_transform(context, part.texture, &part.texture_transform);
}

/* sphere { center, radius, strength ... } or cylinder { end, end, radius, strength ... } */
static bool read_component(Cursor *cursor, BlobReading *reading, const Node *block)
{
	BlobComponent *component = &reading->components[reading->count];
	Cursor inside = cursor_begin(cursor->context, block);
	*component = (BlobComponent){.cylinder = block->word == W_cylinder, .texture = -1};
	if (!cursor_take_vec3(&inside, &component->center) ||
	    (component->cylinder && !cursor_take_vec3(&inside, &component->end)) ||
	    !cursor_take_float(&inside, &component->radius) ||
	    !accept_word_strength(&inside, &component->strength))
		return false;
	read_component_modifiers(&inside, reading, component);
	reading->count++;
	return true;
}

/* component strength, radius, center */
static bool read_old_component(Cursor *cursor, BlobReading *reading)
{
	BlobComponent *component = &reading->components[reading->count];
	*component = (BlobComponent){.texture = -1};
	if (!cursor_take_float(cursor, &component->strength) ||
	    !cursor_take_float(cursor, &component->radius) ||
	    !cursor_take_vec3(cursor, &component->center))
		return false;
	reading->count++;
	return true;
}

static bool read_blob_item(Cursor *cursor, BlobReading *reading, BlobDesc *desc, bool *good)
{
	const Node *block = cursor_accept_block(cursor, W_sphere);
	if (!block)
		block = cursor_accept_block(cursor, W_cylinder);
	if (block)
		*good &= read_component(cursor, reading, block);
	else if (cursor_accept_word(cursor, W_threshold))
		*good &= cursor_take_float(cursor, &desc->threshold);
	else if (cursor_accept_word(cursor, W_component))
		*good &= read_old_component(cursor, reading);
	else
		return false;
	return true;
}

bool build_blob(Cursor *cursor, Object *object)
{
	int nodes = 0;
	for (const Node *node = cursor->at; node; node = node->next)
		nodes++;
	BlobReading reading = {
		.components = ARENA_ARRAY(scene_arena(cursor), BlobComponent, nodes),
		.textures = ARENA_ARRAY(scene_arena(cursor), const Texture *, nodes),
	};
	BlobDesc desc = {.components = reading.components, .threshold = 1};
	const char *error = NULL;
	bool good = true;
	while (read_blob_item(cursor, &reading, &desc, &good))
		;
	if (!good)
		return false;
	desc.count = reading.count;
	object->textures = reading.textures;
	object->texture_count = reading.texture_count;
	return build_shape_set(cursor, object, &blob_class,
			       blob_create(scene_arena(cursor), &desc, &error), &error);
}

/* function { ... }: of at most three arguments. */
static const Function *take_function(Cursor *cursor)
{
	const Node *block = cursor_accept_block(cursor, W_function);
	if (!block) {
		cursor_expected(cursor, "'function {'");
		return NULL;
	}
	Cursor inside = cursor_begin(cursor->context, block);
	const Function *function = cursor_take_item(&inside, VALUE_FUNCTION,
						    "a function of a float");
	if (!function || function_arity(function) <= 3)
		return function;
	diag_error(cursor->context->diag, block->where,
		   "this function has more than three parameters");
	return NULL;
}

/* contained_by { sphere { ... } } or { box { ... } } */
static bool read_container(Cursor *cursor, Container *container)
{
	const Node *block = cursor_accept_block(cursor, W_contained_by);
	if (!block)
		return cursor_expected(cursor, "'{'");
	Cursor outer = cursor_begin(cursor->context, block);
	const Node *shape = cursor_accept_block(&outer, W_sphere);
	container->sphere = shape;
	if (!shape && !(shape = cursor_accept_block(&outer, W_box)))
		return cursor_expected(&outer, "a sphere or a box");
	Cursor inside = cursor_begin(cursor->context, shape);
	if (container->sphere) {
		if (!cursor_take_vec3(&inside, &container->center) ||
		    !cursor_take_float(&inside, &container->radius))
			return false;
	} else {
		Vec3 a, b;
		if (!cursor_take_vec3(&inside, &a) || !cursor_take_vec3(&inside, &b))
			return false;
		container->box = (Box3){vec3_min(a, b), vec3_max(a, b)};
	}
	return cursor_end(&inside) && cursor_end(&outer);
}

static double isosurface_value(const void *function, Vec3 p)
{
	double args[3] = {p.x, p.y, p.z};
	return function_eval(function, args);
}

static bool read_isosurface_item(Cursor *cursor, IsosurfaceDesc *desc, bool *good)
{
	int number = 1;
	if (cursor_peek_word(cursor) == W_contained_by)
		*good &= read_container(cursor, &desc->container);
	else if (cursor_accept_word(cursor, W_threshold))
		*good &= cursor_take_float(cursor, &desc->threshold);
	else if (cursor_accept_word(cursor, W_accuracy))
		*good &= cursor_take_float(cursor, &desc->accuracy);
	else if (cursor_accept_word(cursor, W_max_gradient))
		*good &= cursor_take_float(cursor, &desc->max_gradient);
	else if (cursor_accept_word(cursor, W_evaluate))
		*good &= desc->evaluate = cursor_take_floats(cursor, desc->evaluate_parameters, 3);
	else if (cursor_accept_word(cursor, W_open))
		desc->open = true;
	else if (cursor_accept_word(cursor, W_all_intersections))
		desc->max_trace = 0;
	else if (cursor_accept_word(cursor, W_max_trace))
		*good &= cursor_take_int(cursor, &number);
	else
		return false;
	if (number > 1)
		desc->max_trace = number;
	return true;
}

bool build_isosurface(Cursor *cursor, Object *object)
{
	IsosurfaceDesc desc = isosurface_default();
	bool good = true;
	desc.value = isosurface_value;
	desc.function = take_function(cursor);
	while (read_isosurface_item(cursor, &desc, &good))
		;
	if (!good || !desc.function)
		return false;
	const void *data = isosurface_create(scene_arena(cursor), &desc);
	return build_shape_set(cursor, object, &isosurface_class, data, NULL);
}

typedef struct ParametricFunctions {
	const Function *axis[3];
} ParametricFunctions;

static Vec3 parametric_point(const void *data, double u, double v)
{
	const ParametricFunctions *functions = data;
	double args[3] = {u, v, 0};
	return vec3(function_eval(functions->axis[0], args),
		    function_eval(functions->axis[1], args),
		    function_eval(functions->axis[2], args));
}

/* precompute depth, and which of x, y, z: those arrive as unit vectors. */
static bool read_precompute(Cursor *cursor, int *depth)
{
	if (!cursor_take_int(cursor, depth))
		return false;
	while (cursor_peek_numeric(cursor))
		cursor_next(cursor);
	return true;
}

static bool read_parametric_item(Cursor *cursor, ParametricDesc *desc, bool *good)
{
	if (cursor_peek_word(cursor) == W_contained_by)
		*good &= read_container(cursor, &desc->container);
	else if (cursor_accept_word(cursor, W_accuracy))
		*good &= cursor_take_float(cursor, &desc->accuracy);
	else if (cursor_accept_word(cursor, W_max_gradient))
		*good &= cursor_take_float(cursor, &desc->max_gradient);
	else if (cursor_accept_word(cursor, W_precompute))
		*good &= read_precompute(cursor, &desc->precompute);
	else
		return false;
	return true;
}

bool build_parametric(Cursor *cursor, Object *object)
{
	ParametricFunctions *functions = ARENA_NEW(scene_arena(cursor), ParametricFunctions);
	ParametricDesc desc = parametric_default();
	const char *error = NULL;
	bool good = true;
	for (int i = 0; i < 3; i++)
		if (!(functions->axis[i] = take_function(cursor)))
			return false;
	if (!cursor_take_vec2(cursor, &desc.lo) || !cursor_take_vec2(cursor, &desc.hi))
		return false;
	desc.point = parametric_point;
	desc.function = functions;
	while (read_parametric_item(cursor, &desc, &good))
		;
	if (!good)
		return false;
	const void *data = parametric_create(scene_arena(cursor), &desc, &error);
	return build_shape_set(cursor, object, &parametric_class, data, &error);
}

static const struct {
	Word word;
	JuliaFunction function;
} julia_rows[] = {
	{W_sqr, JULIA_SQR},   {W_cube, JULIA_CUBE},
	{W_exp, JULIA_EXP},   {W_reciprocal, JULIA_RECIPROCAL},
	{W_sin, JULIA_SIN},   {W_asin, JULIA_ASIN},
	{W_sinh, JULIA_SINH}, {W_asinh, JULIA_ASINH},
	{W_cos, JULIA_COS},   {W_acos, JULIA_ACOS},
	{W_cosh, JULIA_COSH}, {W_acosh, JULIA_ACOSH},
	{W_tan, JULIA_TAN},   {W_atan, JULIA_ATAN},
	{W_tanh, JULIA_TANH}, {W_atanh, JULIA_ATANH},
	{W_ln, JULIA_LN},     {W_pwr, JULIA_PWR},
};

static bool accept_julia_function(Cursor *cursor, JuliaDesc *desc)
{
	for (size_t i = 0; i < sizeof julia_rows / sizeof *julia_rows; i++)
		if (cursor_accept_word(cursor, julia_rows[i].word)) {
			desc->function = julia_rows[i].function;
			return true;
		}
	return false;
}

/* A vector of four; a float stands for equal components. */
static bool take_vec4(Cursor *cursor, double out[4])
{
	if (!cursor_peek_numeric(cursor))
		return cursor_expected(cursor, "a vector of 4");
	Value value = cursor_next(cursor)->value;
	for (int i = 0; i < 4; i++)
		out[i] = value.kind == VALUE_FLOAT ? value.number : i < value.size ? value.v[i] : 0;
	return true;
}

/* ( u, v ) */
static bool take_exponent(Cursor *cursor, Vec2 *out)
{
	const Node *pair = cursor_accept_pair(cursor);
	if (!pair)
		return cursor_expected(cursor, "'(', two numbers and ')'");
	Cursor inside = cursor_begin(cursor->context, pair);
	return cursor_take_float(&inside, &out->u) && cursor_take_float(&inside, &out->v) &&
	       cursor_end(&inside);
}

static bool read_julia_item(Cursor *cursor, JuliaDesc *desc, bool *good)
{
	if (cursor_accept_word(cursor, W_quaternion))
		desc->hypercomplex = false;
	else if (cursor_accept_word(cursor, W_hypercomplex))
		desc->hypercomplex = true;
	else if (cursor_accept_word(cursor, W_max_iteration))
		*good &= cursor_take_int(cursor, &desc->max_iteration);
	else if (cursor_accept_word(cursor, W_precision))
		*good &= cursor_take_float(cursor, &desc->precision);
	else if (cursor_accept_word(cursor, W_slice))
		*good &= take_vec4(cursor, desc->slice_normal) &&
			 cursor_take_float(cursor, &desc->slice_distance);
	else if (!accept_julia_function(cursor, desc))
		return false;
	else if (desc->function == JULIA_PWR)
		*good &= take_exponent(cursor, &desc->exponent);
	return true;
}

bool build_julia_fractal(Cursor *cursor, Object *object)
{
	JuliaDesc desc = julia_default();
	const char *error = NULL;
	bool good = take_vec4(cursor, desc.parameter);
	while (good && read_julia_item(cursor, &desc, &good))
		;
	if (!good)
		return false;
	const void *data = julia_create(scene_arena(cursor), &desc, &error);
	return build_shape_set(cursor, object, &julia_fractal_class, data, &error);
}
