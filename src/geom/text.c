/*
 * Text: one prism a letter, its outline from FreeType. A prism lies in xz and is swept along y;
 * letters stand in xy and are swept along z, so y and z are swapped on the way in and out.
 */
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <string.h>

#include "geom/prism.h"
#include "geom/sweep.h"

typedef struct Letter {
	const Prism *prism;
	Box3 box; /* in the prism's space */
} Letter;

typedef struct Text {
	Letter *letters;
	int count;
	Box3 box; /* in the prism's space */
} Text;

static Vec3 swap(Vec3 p) { return vec3(p.x, p.z, p.y); }

/* ---- making ---- */



typedef struct Pen {
	CurveSegment *segments; /* room for every point of the outline */
	int count;
	Vec2 at, start;
	double scale;
	Vec2 origin;
} Pen;

static Vec2 pen_point(const Pen *pen, const FT_Vector *p)
{
	return (Vec2){pen->origin.u + pen->scale * (double)p->x,
		      pen->origin.v + pen->scale * (double)p->y};
}

/* A Bezier segment of degree 3; lower degrees are raised by the callers. */
static void pen_curve(Pen *pen, Vec2 b, Vec2 c, Vec2 d)
{
	Vec2 a = pen->at;
	CurveSegment *g = &pen->segments[pen->count++];
	*g = (CurveSegment){
		.u = {a.u, 3 * (b.u - a.u), 3 * (a.u - 2 * b.u + c.u),
		      d.u - 3 * c.u + 3 * b.u - a.u},
		.v = {a.v, 3 * (b.v - a.v), 3 * (a.v - 2 * b.v + c.v),
		      d.v - 3 * c.v + 3 * b.v - a.v},
	};
	curve_finish(g);
	pen->at = d;
}

static void pen_line(Pen *pen, Vec2 to)
{
	Vec2 from = pen->at;
	if (from.u == to.u && from.v == to.v)
		return;
	CurveSegment *g = &pen->segments[pen->count++];
	*g = (CurveSegment){.u = {from.u, to.u - from.u}, .v = {from.v, to.v - from.v}};
	curve_finish(g);
	pen->at = to;
}

static int on_move(const FT_Vector *to, void *data)
{
	Pen *pen = data;
	if (pen->count > 0)
		pen_line(pen, pen->start);
	pen->at = pen->start = pen_point(pen, to);
	return 0;
}

static int on_line(const FT_Vector *to, void *data)
{
	pen_line(data, pen_point(data, to));
	return 0;
}

static int on_conic(const FT_Vector *control, const FT_Vector *to, void *data)
{
	Pen *pen = data;
	Vec2 a = pen->at, b = pen_point(pen, control), c = pen_point(pen, to);
	CurveSegment *g = &pen->segments[pen->count++];
	*g = (CurveSegment){.u = {a.u, 2 * (b.u - a.u), a.u - 2 * b.u + c.u},
			    .v = {a.v, 2 * (b.v - a.v), a.v - 2 * b.v + c.v}};
	curve_finish(g);
	pen->at = c;
	return 0;
}

static int on_cubic(const FT_Vector *c1, const FT_Vector *c2, const FT_Vector *to, void *data)
{
	pen_curve(data, pen_point(data, c1), pen_point(data, c2), pen_point(data, to));
	return 0;
}

static const FT_Outline_Funcs pen_functions = {on_move, on_line, on_conic, on_cubic, 0, 0};

static void add_letter(Arena *arena, Text *text, const Pen *pen, double thickness)
{
	if (pen->count == 0)
		return;
	Outline outline = outline_create(pen->segments, pen->count);
	Letter *letter = &text->letters[text->count++];
	letter->prism = prism_from_outline(arena, &outline, 0, thickness);
	prism_box(letter->prism, &letter->box);
	text->box = box3_union(text->box, letter->box);
}

/* One code point of UTF-8; a byte that does not belong to any stands for itself (Latin-1). */
static unsigned long next_code(const unsigned char **text)
{
	const unsigned char *p = *text;
	int more = *p >= 0xf0 ? 3 : *p >= 0xe0 ? 2 : *p >= 0xc0 ? 1 : 0;
	unsigned long code = more ? *p & (0x3f >> more) : *p;
	for (int i = 1; i <= more; i++) {
		if ((p[i] & 0xc0) != 0x80) {
			*text = p + 1;
			return *p;
		}
		code = code << 6 | (p[i] & 0x3f);
	}
	*text = p + more + 1;
	return code;
}

/* Symbol fonts keep their letters in the private area U+F000. */
static FT_UInt glyph_of(FT_Face face, unsigned long code)
{
	FT_UInt glyph = FT_Get_Char_Index(face, code);
	return glyph || code > 255 ? glyph : FT_Get_Char_Index(face, 0xf000 + code);
}

static double kerning(FT_Face face, FT_UInt left, FT_UInt right)
{
	FT_Vector delta = {0, 0};
	if (left && right && FT_HAS_KERNING(face))
		FT_Get_Kerning(face, left, right, FT_KERNING_UNSCALED, &delta);
	return (double)delta.x / face->units_per_EM;
}

/* Where the loaded glyph's outline begins beside its origin, in em. */
static double left_edge(FT_Face face)
{
	FT_BBox box;
	FT_Outline_Get_CBox(&face->glyph->outline, &box);
	return (double)box.xMin / face->units_per_EM;
}

static Text *lay_out(Arena *arena, FT_Face face, const TextDesc *desc)
{
	Text *text = ARENA_NEW(arena, Text);
	const unsigned char *at = (const unsigned char *)desc->text;
	text->letters = ARENA_ARRAY(arena, Letter, strlen(desc->text) + 1);
	text->box = box3_empty();
	Vec2 origin = {0, 0};
	for (FT_UInt last = 0, glyph; *at; last = glyph) {
		bool first = at == (const unsigned char *)desc->text;
		glyph = glyph_of(face, next_code(&at));
		if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP) != 0)
			continue;
		FT_Outline *outline = &face->glyph->outline;
		if (first && outline->n_points > 0)
			origin.u = -left_edge(face); /* the first letter's outline begins at 0 */
		Pen pen = {.scale = 1.0 / face->units_per_EM, .origin = origin};
		pen.origin.u += kerning(face, last, glyph);
		/* every point starts at most one segment, every contour needs one more to close */
		pen.segments = ARENA_ARRAY(arena, CurveSegment,
					   outline->n_points + outline->n_contours + 1);
		if (FT_Outline_Decompose(outline, &pen_functions, &pen) == 0) {
			if (pen.count > 0)
				pen_line(&pen, pen.start);
			add_letter(arena, text, &pen, desc->thickness);
		}
		origin.u = pen.origin.u + (double)face->glyph->advance.x / face->units_per_EM +
			   desc->offset.u;
		origin.v += desc->offset.v;
	}
	return text;
}

const void *text_create(Arena *arena, const TextDesc *desc, const char **error)
{
	FT_Library library;
	FT_Face face;
	*error = FT_Init_FreeType(&library) ? "the font library does not start" : NULL;
	if (*error)
		return NULL;
	Text *text = NULL;
	if (FT_New_Face(library, desc->font_path, 0, &face) != 0 || !FT_IS_SCALABLE(face))
		*error = "this is not a font with outlines";
	else
		text = lay_out(arena, face, desc);
	FT_Done_FreeType(library); /* takes its faces along */
	return text;
}

/* ---- the class ---- */

static bool text_bounds(const void *data, Box3 *box)
{
	const Text *text = data;
	*box = (Box3){swap(text->box.lo), swap(text->box.hi)};
	return true;
}

static bool ray_meets(const Ray *ray, Box3 box)
{
	double near = ray->tmin, far = ray->tmax;
	for (int axis = 0; axis < 3; axis++) {
		double o = vec3_axis(ray->origin, axis),
		       inverse = 1 / vec3_axis(ray->direction, axis);
		double a = (vec3_axis(box.lo, axis) - o) * inverse,
		       b = (vec3_axis(box.hi, axis) - o) * inverse;
		near = fmax(near, fmin(a, b));
		far = fmin(far, fmax(a, b));
	}
	return near <= far * (1 + 1e-12) + 1e-12;
}

static void text_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	const Text *text = self->data;
	Ray swapped = {swap(ray->origin), swap(ray->direction), ray->tmin, ray->tmax};
	if (!ray_meets(&swapped, text->box))
		return;
	for (int i = 0; i < text->count; i++) {
		if (ray_meets(&swapped, text->letters[i].box))
			prism_cross(text->letters[i].prism, &swapped, (Hit){.shape = self, .v = i},
				    out);
	}
}

static bool text_inside(const void *data, Vec3 p)
{
	const Text *text = data;
	for (int i = 0; i < text->count; i++) {
		if (box3_contains(text->letters[i].box, swap(p)) &&
		    prism_contains(text->letters[i].prism, swap(p)))
			return true;
	}
	return false;
}

static Vec3 text_normal(const void *data, const Hit *hit, Vec3 p)
{
	const Text *text = data;
	return swap(prism_outward(text->letters[(int)hit->v].prism, hit, swap(p)));
}

static bool text_flat_at(const void *data, const Hit *hit)
{
	const Text *text = data;
	return prism_is_flat(text->letters[(int)hit->v].prism, hit);
}

const ShapeClass text_class = {
	.name = "text",
	.bounds = text_bounds,
	.intersect = text_intersect,
	.inside = text_inside,
	.normal = text_normal,
	.flat_at = text_flat_at,
};
