/*
 * Normals: the shading normal bent by a pattern. A pattern with a perturbation of its own (bumps,
 * ripples...) adds that; any other is seen as a height field whose slope comes from four samples at
 * the corners of a small tetrahedron, where POV-Ray takes them. Only transformations among the
 * warps turn the normal itself.
 */
#include <math.h>

#include "surface/blend.h"
#include "surface/image_map.h"
#include "surface/texture.h"

/* POV-Ray's heights are this many times too high, and pits are positive, so that amounts from 0 to
 * 1 look right. */
static const double HEIGHT_FACTOR = -5.0;
/* The step that POV-Ray's amounts were tuned for. */
static const double REFERENCE_ACCURACY = 0.02;

/* The corners of the regular tetrahedron round the unit sphere, one on top. */
static const Vec3 CORNERS[4] = {
	{0.942809041, -0.333333333, 0.0},
	{-0.471404521, -0.333333333, 0.816496581},
	{-0.471404521, -0.333333333, -0.816496581},
	{0.0, 1.0, 0.0},
};

/* The height over a pattern's value: a Hermite cubic between entries. As in POV-Ray a slope counts
 * per distance of the two entries, not per unit of the value. */
static double slope_map_height(const Normal *normal, double value)
{
	const SlopeEntry *slopes = normal->slopes;
	if (normal->slope_count == 0)
		return value;
	BlendSpan span = blend_find(slopes, sizeof *slopes, normal->slope_count, value);
	if (span.lower == span.upper)
		return slopes[span.upper].height;
	const SlopeEntry *a = &slopes[span.lower], *b = &slopes[span.upper];
	double t = span.weight, t2 = t * t, t3 = t2 * t;
	return (2 * t3 - 3 * t2 + 1) * a->height + (3 * t2 - 2 * t3) * b->height +
	       (t3 - 2 * t2 + t) * a->slope + (t3 - t2) * b->slope;
}

static Vec3 bend_by_slope(const Normal *normal, const SurfacePoint *at, Vec3 n)
{
	double factor = HEIGHT_FACTOR * normal->amount * REFERENCE_ACCURACY / normal->accuracy;
	for (int i = 0; i < 4; i++) {
		SurfacePoint sample = *at;
		sample.p = vec3_mad(at->p, normal->accuracy, CORNERS[i]);
		double height = slope_map_height(normal,
						 pattern_value_unwarped(&normal->pattern, &sample));
		n = vec3_mad(n, factor * height, CORNERS[i]);
	}
	return n;
}

static Vec3 bend_by_pattern(const Normal *normal, const SurfacePoint *at, Vec3 n)
{
	const PatternClass *class = normal->pattern.class;
	if (class && class->bump) {
		class->bump(&normal->pattern, at, normal->amount, &n);
		return n;
	}
	return class && class->value ? bend_by_slope(normal, at, n) : n;
}

static Vec3 bend_by_map(const Normal *normal, const SurfacePoint *at, Vec3 n)
{
	const NormalEntry *entries = normal->normals;
	double value = pattern_value_unwarped(&normal->pattern, at);
	BlendSpan span = blend_find(entries, sizeof *entries, normal->normal_count, value);
	Vec3 upper = normal_perturb(entries[span.upper].normal, at, n);
	if (span.lower == span.upper)
		return upper;
	return vec3_lerp(normal_perturb(entries[span.lower].normal, at, n), upper, span.weight);
}

static Vec3 bend_by_average(const Normal *normal, const SurfacePoint *at, Vec3 n)
{
	Vec3 sum = vec3_all(0);
	for (int i = 0; i < normal->normal_count; i++)
		sum = vec3_mad(sum, normal->normals[i].key,
			       normal_perturb(normal->normals[i].normal, at, n));
	return vec3_length2(sum) > 0 ? sum : n;
}

static Vec3 bend(const Normal *normal, const SurfacePoint *at, Vec3 n)
{
	switch (normal->kind) {
	case NORMAL_NORMAL_MAP:
	case NORMAL_LIST: return bend_by_map(normal, at, n);
	case NORMAL_AVERAGE: return bend_by_average(normal, at, n);
	case NORMAL_BUMP_MAP: return image_map_bump(normal->image, at->p, normal->amount, n);
	default: return bend_by_pattern(normal, at, n);
	}
}

/* A perturbation that cancels the normal, or a pattern that gives no number, leaves the normal as
 * it was. */
static Vec3 sound_or(Vec3 n, Vec3 otherwise)
{
	return vec3_is_finite(n) && vec3_length2(n) > 0 ? n : otherwise;
}

Vec3 normal_perturb(const Normal *normal, const SurfacePoint *at, Vec3 n)
{
	bool keep = normal->no_bump_scale;
	SurfacePoint inner = *at;
	if (normal->kind == NORMAL_UV) {
		inner.p = vec3(at->uv.u, at->uv.v, 0);
		return normal_perturb(normal->normals[0].normal, &inner, n);
	}
	inner.p = pattern_warp_point(&normal->pattern, at);
	Vec3 local = pattern_warp_normal(&normal->pattern, n);
	local = bend(normal, &inner, keep ? local : vec3_normalize(local));
	Vec3 bent = sound_or(pattern_unwarp_normal(&normal->pattern, local), n);
	return keep ? bent : vec3_normalize(bent);
}

bool normal_uses_uv(const Normal *normal)
{
	if (normal->kind == NORMAL_UV)
		return true;
	bool nested = normal->kind == NORMAL_NORMAL_MAP || normal->kind == NORMAL_LIST ||
		      normal->kind == NORMAL_AVERAGE;
	for (int i = 0; nested && i < normal->normal_count; i++)
		if (normal_uses_uv(normal->normals[i].normal))
			return true;
	return false;
}
