/*
 * Shapes from plane curves: prism, lathe, sor (surface of revolution) and text.
 */
#ifndef GEOM_SWEEP_H
#define GEOM_SWEEP_H

#include "base/arena.h"
#include "geom/outline.h"
#include "geom/shape.h"

/* Curves in the xz plane swept along y from low to high; conic: scaled by y, the apex at the
 * origin. */
typedef struct PrismDesc {
	CurveKind kind;
	bool conic, open;
	double low, high;
	const Vec2 *points; /* (x, z) */
	int point_count;
} PrismDesc;

/* data: opaque. NULL with *error set for a curve that does not close or has too few points. */
const void *prism_create(Arena *arena, const PrismDesc *desc, const char **error);
extern const ShapeClass prism_class;

/* A curve (radius, y) turned about the y axis. */
typedef struct LatheDesc {
	CurveKind kind;
	const Vec2 *points;
	int point_count;
} LatheDesc;

/* As prism_create. */
const void *lathe_create(Arena *arena, const LatheDesc *desc, const char **error);
extern const ShapeClass lathe_class;

/* Radius over rising y; the first and last points are control points only. */
typedef struct SorDesc {
	const Vec2 *points;
	int point_count;
	bool open;
} SorDesc;

/* NULL with *error set for fewer than four points, or heights that do not rise. */
const void *sor_create(Arena *arena, const SorDesc *desc, const char **error);
extern const ShapeClass sor_class;

/* Letters of a TrueType (or any FreeType) font, one unit an em, standing on y = 0 from x = 0 on,
 * thick along z from 0. offset is added to each letter's advance. */
typedef struct TextDesc {
	const char *font_path;
	const char *text; /* UTF-8 */
	double thickness;
	Vec2 offset;
} TextDesc;

/* NULL with *error set when the font cannot be read. */
const void *text_create(Arena *arena, const TextDesc *desc, const char **error);
extern const ShapeClass text_class;

#endif
