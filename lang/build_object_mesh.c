/* Triangles and what is made of them: triangle, smooth_triangle, mesh, mesh2, bicubic_patch,
 * polygon. */
#include "lang/build_object.h"

#include "geom/mesh.h"
#include "geom/patch.h"
#include "lang/build_texture.h"

static Arena *scene_arena(const Cursor *cursor) { return cursor->context->builder->arena; }

/* Corners, with a normal after each for a smooth one, and uv_vectors. */
static bool read_triangle(Cursor *cursor, Triangle *triangle, bool smooth)
{
	*triangle = (Triangle){.smooth = smooth};
	for (int i = 0; i < 3; i++)
		if (!cursor_take_vec3(cursor, &triangle->corner[i]) ||
		    (smooth && !cursor_take_vec3(cursor, &triangle->normal[i])))
			return false;
	triangle->has_uv = cursor_accept_word(cursor, W_uv_vectors);
	for (int i = 0; i < 3 && triangle->has_uv; i++)
		if (!cursor_take_vec2(cursor, &triangle->uv[i]))
			return false;
	return true;
}

static bool build_one_triangle(Cursor *cursor, Object *object, bool smooth)
{
	Triangle *triangle = ARENA_NEW(scene_arena(cursor), Triangle);
	if (!read_triangle(cursor, triangle, smooth))
		return false;
	return build_shape_set(cursor, object, smooth ? &smooth_triangle_class : &triangle_class,
			       triangle, NULL);
}

bool build_triangle(Cursor *cursor, Object *object)
{
	return build_one_triangle(cursor, object, false);
}

bool build_smooth_triangle(Cursor *cursor, Object *object)
{
	return build_one_triangle(cursor, object, true);
}

/* ---- mesh ---- */

/* A mesh { } being read: every triangle brings three corners of its own. */
typedef struct MeshReading {
	float (*vertices)[3], (*normals)[3], (*uvs)[2];
	int (*triangles)[3], (*normal_indices)[3], (*textures)[3];
	int count;
	const Texture **list;
	int list_count;
	bool smooth, has_uv, textured;
} MeshReading;

static int number_texture(MeshReading *reading, const Texture *texture)
{
	for (int i = reading->list_count - 1; i >= 0; i--)
		if (reading->list[i] == texture)
			return i;
	reading->list[reading->list_count] = texture;
	return reading->list_count++;
}

/* texture { } or texture_list { } of one triangle: the number of each corner's. */
static void read_triangle_textures(Cursor *cursor, MeshReading *reading, int numbers[3])
{
	const Node *block = cursor_accept_block(cursor, W_texture);
	numbers[0] = numbers[1] = numbers[2] = -1;
	if (block) {
		numbers[0] = numbers[1] = numbers[2] =
			number_texture(reading, build_texture(cursor->context, block));
	} else if ((block = cursor_accept_block(cursor, W_texture_list))) {
		Cursor inside = cursor_begin(cursor->context, block);
		for (int i = 0; i < 3; i++) {
			const Texture *texture = cursor_accept_item(&inside, VALUE_TEXTURE);
			const Node *inner = texture ? NULL
						    : cursor_accept_block(&inside, W_texture);
			if (inner)
				texture = build_texture(cursor->context, inner);
			if (texture)
				numbers[i] = number_texture(reading, texture);
			else
				cursor_expected(&inside, "three textures");
		}
		cursor_end(&inside);
	}
	reading->textured |= block != NULL;
}

static void add_triangle(MeshReading *reading, const Triangle *triangle)
{
	int row = reading->count++;
	for (int i = 0; i < 3; i++) {
		int corner = 3 * row + i;
		vec3_to_floats(triangle->corner[i], reading->vertices[corner]);
		vec3_to_floats(triangle->normal[i], reading->normals[corner]);
		reading->uvs[corner][0] = (float)triangle->uv[i].u;
		reading->uvs[corner][1] = (float)triangle->uv[i].v;
		reading->triangles[row][i] = corner;
		reading->normal_indices[row][i] = triangle->smooth ? corner : -1;
	}
	reading->smooth |= triangle->smooth;
	reading->has_uv |= triangle->has_uv;
}

static void read_mesh_triangle(Cursor *cursor, MeshReading *reading, const Node *block)
{
	Triangle triangle;
	Cursor inside = cursor_begin(cursor->context, block);
	if (read_triangle(&inside, &triangle, block->word == W_smooth_triangle)) {
		read_triangle_textures(&inside, reading, reading->textures[reading->count]);
		add_triangle(reading, &triangle);
	}
	cursor_end(&inside);
}

static MeshReading begin_mesh(Cursor *cursor)
{
	Arena *arena = scene_arena(cursor);
	int count = 0;
	for (const Node *node = cursor->at; node; node = node->next)
		count += node->kind == NODE_BLOCK &&
			 (node->word == W_triangle || node->word == W_smooth_triangle);
	MeshReading reading = {0};
	reading.vertices = arena_alloc(arena, sizeof(float[3]) * 3 * (size_t)count);
	reading.normals = arena_alloc(arena, sizeof(float[3]) * 3 * (size_t)count);
	reading.uvs = arena_alloc(arena, sizeof(float[2]) * 3 * (size_t)count);
	reading.triangles = arena_alloc(arena, sizeof(int[3]) * (size_t)count);
	reading.normal_indices = arena_alloc(arena, sizeof(int[3]) * (size_t)count);
	reading.textures = arena_alloc(arena, sizeof(int[3]) * (size_t)count);
	reading.list = ARENA_ARRAY(arena, const Texture *, 3 * count);
	return reading;
}

/* hierarchy and inside_vector, which stand before the object's modifiers. */
static bool read_mesh_words(Cursor *cursor, MeshDesc *desc)
{
	for (;;) {
		if (cursor_accept_word(cursor, W_hierarchy))
			cursor_optional_bool(cursor);
		else if (!cursor_accept_word(cursor, W_inside_vector))
			return true;
		else if (!(desc->has_inside_vector = cursor_take_vec3(cursor,
								      &desc->inside_vector)))
			return false;
	}
}

static bool finish_mesh(Cursor *cursor, Object *object, MeshDesc *desc)
{
	const char *error = NULL;
	if (!read_mesh_words(cursor, desc))
		return false;
	return build_shape_set(cursor, object, &mesh_class,
			       mesh_create(scene_arena(cursor), desc, &error), &error);
}

bool build_mesh(Cursor *cursor, Object *object)
{
	MeshReading reading = begin_mesh(cursor);
	const Node *block;
	while ((block = cursor_accept_block(cursor, W_triangle)) ||
	       (block = cursor_accept_block(cursor, W_smooth_triangle)))
		read_mesh_triangle(cursor, &reading, block);
	MeshDesc desc = {
		.vertices = (const float (*)[3])reading.vertices, .vertex_count = 3 * reading.count,
		.triangles = (const int (*)[3])reading.triangles, .triangle_count = reading.count,
	};
	if (reading.smooth) {
		desc.normals = (const float (*)[3])reading.normals;
		desc.normal_count = desc.vertex_count;
		desc.normal_indices = (const int (*)[3])reading.normal_indices;
	}
	if (reading.has_uv) {
		desc.uvs = (const float (*)[2])reading.uvs;
		desc.uv_count = desc.vertex_count;
	}
	if (reading.textured) {
		desc.textures = (const int (*)[3])reading.textures;
		object->textures = reading.list;
		object->texture_count = reading.list_count;
	}
	return finish_mesh(cursor, object, &desc);
}

/* ---- mesh2 ---- */

/* The count at the head of a section, no larger than what follows can be. */
static bool take_count(Cursor *cursor, int *count)
{
	int following = 0;
	if (!cursor_take_int(cursor, count))
		return false;
	for (const Node *node = cursor->at; node; node = node->next)
		following++;
	if (*count >= 0 && *count <= following)
		return true;
	diag_error(cursor->context->diag, cursor->block->where,
		   "'%s' announces %d but only %d follow", word_text(cursor->block->word), *count,
		   following);
	cursor->at = NULL;
	return false;
}

static float (*read_vectors(Cursor *cursor, const Node *block, int *count))[3]
{
	Cursor inside = cursor_begin(cursor->context, block);
	if (!take_count(&inside, count))
		return NULL;
	float(*vectors)[3] = arena_alloc(scene_arena(cursor), sizeof *vectors * (size_t)*count);
	for (int i = 0; i < *count; i++) {
		Vec3 v;
		if (!cursor_take_vec3(&inside, &v))
			return NULL;
		vec3_to_floats(v, vectors[i]);
	}
	return cursor_end(&inside) ? vectors : NULL;
}

static float (*read_uvs(Cursor *cursor, const Node *block, int *count))[2]
{
	Cursor inside = cursor_begin(cursor->context, block);
	if (!take_count(&inside, count))
		return NULL;
	float(*uvs)[2] = arena_alloc(scene_arena(cursor), sizeof *uvs * (size_t)*count);
	for (int i = 0; i < *count; i++) {
		Vec2 v;
		if (!cursor_take_vec2(&inside, &v))
			return NULL;
		uvs[i][0] = (float)v.u;
		uvs[i][1] = (float)v.v;
	}
	return cursor_end(&inside) ? uvs : NULL;
}

/* One or three texture numbers after a face; none: -1. */
static bool read_face_textures(Cursor *cursor, int numbers[3])
{
	numbers[0] = numbers[1] = numbers[2] = -1;
	if (!cursor_peek_float(cursor))
		return false;
	cursor_take_int(cursor, &numbers[0]);
	numbers[1] = numbers[2] = numbers[0];
	if (cursor_peek_float(cursor)) {
		cursor_take_int(cursor, &numbers[1]);
		cursor_take_int(cursor, &numbers[2]);
	}
	return true;
}

static bool read_faces(Cursor *cursor, const Node *block, MeshDesc *desc)
{
	Cursor inside = cursor_begin(cursor->context, block);
	bool textured = false;
	int count;
	if (!take_count(&inside, &count))
		return false;
	int(*faces)[3] = arena_alloc(scene_arena(cursor), sizeof *faces * (size_t)count);
	int(*textures)[3] = arena_alloc(scene_arena(cursor), sizeof *textures * (size_t)count);
	for (int i = 0; i < count; i++) {
		if (!cursor_take_ints(&inside, faces[i]))
			return false;
		textured |= read_face_textures(&inside, textures[i]);
	}
	desc->triangles = (const int (*)[3])faces;
	desc->triangle_count = count;
	desc->textures = textured ? (const int (*)[3])textures : NULL;
	return cursor_end(&inside);
}

/* Rows for as many faces as there are, at most `faces`; the rest stays -1. */
static const int (*read_index_rows(Cursor *cursor, const Node *block, int faces))[3]
{
	Cursor inside = cursor_begin(cursor->context, block);
	int count;
	if (!take_count(&inside, &count))
		return NULL;
	int (*rows)[3] = arena_alloc(scene_arena(cursor),
				     sizeof *rows * (size_t)(faces > count ? faces : count));
	for (int i = 0; i < count; i++)
		if (!cursor_take_ints(&inside, rows[i]))
			return NULL;
	for (int i = count; i < faces; i++)
		rows[i][0] = rows[i][1] = rows[i][2] = -1;
	cursor_end(&inside);
	return (const int (*)[3])rows;
}

static bool read_texture_list(Cursor *cursor, const Node *block, Object *object)
{
	Cursor inside = cursor_begin(cursor->context, block);
	int count;
	if (!take_count(&inside, &count))
		return false;
	const Texture **list = ARENA_ARRAY(scene_arena(cursor), const Texture *, count);
	for (int i = 0; i < count; i++) {
		const Node *texture = cursor_accept_block(&inside, W_texture);
		if (texture)
			list[i] = build_texture(cursor->context, texture);
		else if (!(list[i] = cursor_accept_item(&inside, VALUE_TEXTURE)))
			return cursor_expected(&inside, "a texture");
	}
	object->textures = list;
	object->texture_count = count;
	return cursor_end(&inside);
}

/* One section of a mesh2; false when none is next. */
static bool read_section(Cursor *cursor, MeshDesc *desc, Object *object, bool *good)
{
	const Node *block;
	if ((block = cursor_accept_block(cursor, W_vertex_vectors)))
		*good &= !!(desc->vertices = (const float (*)[3])read_vectors(cursor, block,
									      &desc->vertex_count));
	else if ((block = cursor_accept_block(cursor, W_normal_vectors)))
		*good &= !!(desc->normals = (const float (*)[3])read_vectors(cursor, block,
									     &desc->normal_count));
	else if ((block = cursor_accept_block(cursor, W_uv_vectors)))
		*good &= !!(
			desc->uvs = (const float (*)[2])read_uvs(cursor, block, &desc->uv_count));
	else if ((block = cursor_accept_block(cursor, W_texture_list)))
		*good &= read_texture_list(cursor, block, object);
	else if ((block = cursor_accept_block(cursor, W_face_indices)))
		*good &= read_faces(cursor, block, desc);
	else if ((block = cursor_accept_block(cursor, W_normal_indices)))
		*good &= !!(desc->normal_indices = read_index_rows(cursor, block,
								   desc->triangle_count));
	else if ((block = cursor_accept_block(cursor, W_uv_indices)))
		*good &= !!(
			desc->uv_indices = read_index_rows(cursor, block, desc->triangle_count));
	else
		return false;
	return true;
}

/* Texture numbers beyond the list become the object's own texture, with a report. */
static bool check_textures(Cursor *cursor, const MeshDesc *desc, int count)
{
	for (int i = 0; desc->textures && i < desc->triangle_count; i++)
		for (int k = 0; k < 3; k++)
			if (desc->textures[i][k] < -1 || desc->textures[i][k] >= count) {
				diag_error(cursor->context->diag, cursor->block->where,
					   "mesh2: face %d names texture %d, the list has %d", i,
					   desc->textures[i][k], count);
				return false;
			}
	return true;
}

bool build_mesh2(Cursor *cursor, Object *object)
{
	MeshDesc desc = {0};
	bool good = true;
	while (read_section(cursor, &desc, object, &good))
		;
	if (!good || !check_textures(cursor, &desc, object->texture_count))
		return false;
	if (!desc.triangles || !desc.vertices)
		return cursor_expected(cursor, "'vertex_vectors {' and 'face_indices {'");
	if (desc.normals && !desc.normal_indices && desc.normal_count != desc.vertex_count) {
		diag_error(cursor->context->diag, cursor->block->where,
			   "mesh2: normal_indices are needed where normals and vertices differ in "
			   "number");
		return false;
	}
	return finish_mesh(cursor, object, &desc);
}

/* ---- patches ---- */

static bool read_patch_word(Cursor *cursor, PatchDesc *desc, bool *good)
{
	double type;
	if (cursor_accept_word(cursor, W_type))
		*good &= cursor_take_float(cursor, &type);
	else if (cursor_accept_word(cursor, W_u_steps))
		*good &= cursor_take_int(cursor, &desc->u_steps);
	else if (cursor_accept_word(cursor, W_v_steps))
		*good &= cursor_take_int(cursor, &desc->v_steps);
	else if (cursor_accept_word(cursor, W_flatness))
		*good &= cursor_take_float(cursor, &desc->flatness);
	else
		return false;
	return true;
}

bool build_bicubic_patch(Cursor *cursor, Object *object)
{
	PatchDesc desc = {0};
	Vec2 uv[4];
	bool good = true;
	while (read_patch_word(cursor, &desc, &good))
		;
	if (cursor_accept_word(cursor, W_uv_vectors)) {
		for (int i = 0; i < 4; i++)
			good = good && cursor_take_vec2(cursor, &uv[i]);
		desc.uv = uv;
	}
	for (int i = 0; i < 16; i++)
		good = good && cursor_take_vec3(cursor, &desc.control[i]);
	if (!good)
		return false;
	return build_shape_set(cursor, object, &mesh_class,
			       bicubic_patch_create(scene_arena(cursor), &desc), NULL);
}

bool build_polygon(Cursor *cursor, Object *object)
{
	const char *error = NULL;
	int count;
	if (!take_count(cursor, &count))
		return false;
	Vec3 *points = ARENA_ARRAY(cursor->context->items, Vec3, count);
	for (int i = 0; i < count; i++)
		if (!cursor_take_vec3(cursor, &points[i]))
			return false;
	const void *data = polygon_create(scene_arena(cursor), points, count, &error);
	return build_shape_set(cursor, object, &polygon_class, data, &error);
}
