/*
 * Warps. The formulas were found by sending points through warps with POV-Ray 3.7 (gradients along
 * x, y and z show where a point goes); tests/unit/test_pattern.c holds such points.
 *
 * The classic turbulence applies after every other warp, wherever its word stands.
 */
#include "surface/warp.h"

#include <math.h>
#include <stddef.h>

WarpMapping warp_mapping_default(void)
{
	return (WarpMapping){.orientation = {0, 0, 1}, .major_radius = 1};
}

WarpBlackHole warp_black_hole_default(void)
{
	return (WarpBlackHole){.radius = 1, .strength = 1, .falloff = 2};
}

/* A repeated hole has to stay inside its block: its centre is moved and the block widened until it
 * does. */
static void settle_axis(double *center, double *repeat, double radius, double uncertainty)
{
	if (*repeat == 0)
		return;
	*center = fmax(*center, radius);
	*repeat = fmax(*repeat, *center + radius + uncertainty);
}

static void settle_black_hole(WarpBlackHole *hole)
{
	Vec3 u = hole->uncertain ? hole->uncertainty : vec3_all(0);
	settle_axis(&hole->center.x, &hole->repeat.x, hole->radius, u.x);
	settle_axis(&hole->center.y, &hole->repeat.y, hole->radius, u.y);
	settle_axis(&hole->center.z, &hole->repeat.z, hole->radius, u.z);
}

void warp_add(Arena *arena, const Warp **list, const Warp *warp)
{
	Warp *node = arena_copy(arena, warp, sizeof *warp);
	if (node->kind == WARP_BLACK_HOLE && node->u.black_hole.repeats)
		settle_black_hole(&node->u.black_hole);
	node->next = *list;
	*list = node;
}

void warp_add_transform(Arena *arena, const Warp **list, const Transform *transform)
{
	Warp node = {.kind = WARP_TRANSFORM, .u.transform = *transform};
	const Warp *last = *list;
	if (last && last->kind == WARP_TRANSFORM) {
		node.u.transform = transform_compose(&last->u.transform, transform);
		last = last->next;
	}
	*list = last;
	warp_add(arena, list, &node);
}

const Turbulence *warp_find_classic(const Warp *list)
{
	for (; list; list = list->next)
		if (list->kind == WARP_CLASSIC)
			return &list->u.turbulence;
	return NULL;
}

Turbulence warp_classic(const Warp *list)
{
	const Turbulence *found = warp_find_classic(list);
	return found ? *found : turbulence_default();
}

/* A later node hides the earlier ones. */
void warp_set_classic(Arena *arena, const Warp **list, const Turbulence *turbulence)
{
	Warp node = {.kind = WARP_CLASSIC, .u.turbulence = *turbulence};
	warp_add(arena, list, &node);
}

static Vec3 apply_turbulence(const Turbulence *t, Vec3 p, int generator)
{
	if (t->amount.x == 0 && t->amount.y == 0 && t->amount.z == 0)
		return p;
	return vec3_add(p, vec3_mul(t->amount, turbulence_vector(p, t, generator)));
}

static void set_axis(Vec3 *v, int axis, double value)
{
	*(axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z) = value;
}

static Vec3 apply_repeat(const WarpRepeat *r, Vec3 p)
{
	double along = vec3_axis(p, r->axis), copy = floor(along / r->width);
	along -= copy * r->width;
	if (fmod(copy, 2) != 0) {
		p = vec3(r->flip.x != 0 ? -p.x : p.x, r->flip.y != 0 ? -p.y : p.y,
		         r->flip.z != 0 ? -p.z : p.z);
		if (vec3_axis(r->flip, r->axis) != 0)
			along = r->width - along;
	}
	set_axis(&p, r->axis, along);
	return vec3_mad(p, copy, r->offset);
}

static double block_number(double at, double repeat)
{
	return repeat != 0 ? floor(at / repeat) : 0;
}

/* The centre of the hole in the point's block; turbulence moves it by the random numbers of
 * crackle's cells. */
static Vec3 black_hole_center(const WarpBlackHole *hole, Vec3 p)
{
	if (!hole->repeats)
		return hole->center;
	Vec3 block = vec3(block_number(p.x, hole->repeat.x), block_number(p.y, hole->repeat.y),
	                  block_number(p.z, hole->repeat.z));
	Vec3 center = vec3_add(hole->center, vec3_mul(block, hole->repeat));
	if (hole->uncertain)
		center = vec3_add(center, vec3_mul(hole->uncertainty, noise_cube_random(block)));
	return center;
}

static Vec3 apply_black_hole(const WarpBlackHole *hole, Vec3 p)
{
	Vec3 center = black_hole_center(hole, p);
	Vec3 delta = vec3_sub(p, center);
	double length = vec3_length(delta);
	if (length >= hole->radius)
		return p;
	double force = hole->strength * pow((hole->radius - length) / hole->radius, hole->falloff);
	if (force > 1)
		force = 1;
	return vec3_mad(p, hole->inverse ? -force : force, delta);
}

/* The mapped coordinates turned so that the third one lies along the orientation. */
static Vec3 orient(const WarpMapping *m, double u, double v, double d)
{
	Vec3 o = vec3_normalize(m->orientation);
	return vec3(o.x * d + (o.y + o.z) * u, (o.x + o.z) * v - o.y * d,
		    o.y * v + o.z * d - o.x * u);
}

static double distance_factor(const WarpMapping *m, double distance)
{
	return m->distance == 0 ? 1 : m->distance == 1 ? distance : pow(distance, m->distance);
}

static Vec3 apply_cylindrical(const WarpMapping *m, Vec3 p)
{
	double radius = sqrt(p.x * p.x + p.z * p.z);
	if (radius == 0)
		return p;
	return orient(m, vec3_turn(p) * distance_factor(m, radius), p.y, radius);
}

static Vec3 apply_spherical(const WarpMapping *m, Vec3 p)
{
	double length = vec3_length(p);
	if (length == 0)
		return p;
	double factor = distance_factor(m, length),
		   height = atan2(p.y, sqrt(p.x * p.x + p.z * p.z)) / M_PI + 0.5;
	return orient(m, vec3_turn(p) * factor, height * factor, length);
}

static Vec3 apply_toroidal(const WarpMapping *m, Vec3 p)
{
	double out = sqrt(p.x * p.x + p.z * p.z) - m->major_radius,
		   length = sqrt(out * out + p.y * p.y);
	double factor = distance_factor(m, length), turn = atan2(p.y, out) / (2 * M_PI) + 0.5;
	return orient(m, vec3_turn(p) * factor, turn * factor, length);
}

/* The faces of a cube unfolded to a cross of 4 by 3: -x, +z, +x, -z in the middle row, +y above and
 * -y below +z. */
static Vec3 apply_cubic(Vec3 p)
{
	double ax = fabs(p.x), ay = fabs(p.y), az = fabs(p.z);
	int column, row = 1;
	double u, v, d;
	if (ax >= ay && ax >= az) {
		column = p.x > 0 ? 2 : 0, d = ax, u = p.x > 0 ? -p.z : p.z, v = p.y;
	} else if (ay >= az) {
		column = 1, row = p.y > 0 ? 2 : 0, d = ay, u = p.x, v = p.y > 0 ? -p.z : p.z;
	} else {
		column = p.z > 0 ? 1 : 3, d = az, u = p.z > 0 ? p.x : -p.x, v = p.y;
	}
	if (d == 0)
		return p;
	return vec3((column + 0.5 * (1 + u / d)) / 4, (row + 0.5 * (1 + v / d)) / 3, d);
}

static Vec3 apply_one(const Warp *warp, Vec3 p, int generator)
{
	switch (warp->kind) {
	case WARP_TRANSFORM:
		return transform_point_inverse(&warp->u.transform, p);
	case WARP_TURBULENCE:
		return apply_turbulence(&warp->u.turbulence, p, generator);
	case WARP_REPEAT:
		return apply_repeat(&warp->u.repeat, p);
	case WARP_BLACK_HOLE:
		return apply_black_hole(&warp->u.black_hole, p);
	case WARP_PLANAR:
		return orient(&warp->u.mapping, p.x, p.y, warp->u.mapping.distance);
	case WARP_CYLINDRICAL:
		return apply_cylindrical(&warp->u.mapping, p);
	case WARP_SPHERICAL:
		return apply_spherical(&warp->u.mapping, p);
	case WARP_TOROIDAL:
		return apply_toroidal(&warp->u.mapping, p);
	case WARP_CUBIC:
		return apply_cubic(p);
	case WARP_CLASSIC:
		break;
	}
	return p;
}

Vec3 warp_apply(const Warp *list, Vec3 p, int generator, bool skip_classic)
{
	const Turbulence *classic = skip_classic ? NULL : warp_find_classic(list);
	for (const Warp *warp = list; warp; warp = warp->next)
		p = apply_one(warp, p, generator);
	return classic ? apply_turbulence(classic, p, generator) : p;
}
