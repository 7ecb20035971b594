/*
 * Surfaces of revolution: between two heights the squared radius is a cubic of y, f(y), that meets
 * its neighbours with their slopes. A ray gives a cubic in t.
 */
#include "geom/polynomial.h"
#include "geom/ray_box.h"
#include "geom/sweep.h"

typedef struct Piece {
	double low, high;
	double f[4]; /* r^2 = f0 + f1 w + f2 w^2 + f3 w^3, w = y - low */
	double largest; /* r^2 */
} Piece;

typedef struct Sor {
	const Piece *pieces;
	int count;
	double radius;               /* largest */
	double cap_low2, cap_high2;  /* squared radii of the ends; 0 when open */
} Sor;

enum { CAP_LOW = -1, CAP_HIGH = -2 };

static double slope_of_square(const Vec2 *p, int i)
{
	return 2 * p[i].u * (p[i + 1].u - p[i - 1].u) / (p[i + 1].v - p[i - 1].v);
}

static double square_at(const Piece *piece, double y)
{
	return polynomial_eval(piece->f, 3, y - piece->low);
}

static double largest_square(const Piece *piece)
{
	double best = fmax(square_at(piece, piece->low), square_at(piece, piece->high)), w[2];
	int count = polynomial_quadratic(3 * piece->f[3], 2 * piece->f[2], piece->f[1], w);
	for (int i = 0; i < count; i++) {
		if (w[i] > 0 && w[i] < piece->high - piece->low)
			best = fmax(best, square_at(piece, piece->low + w[i]));
	}
	return best;
}

/* Hermite interpolation of r^2 between points i and i + 1. */
static Piece make_piece(const Vec2 *p, int i)
{
	double h = p[i + 1].v - p[i].v, a = p[i].u * p[i].u, b = p[i + 1].u * p[i + 1].u;
	double da = slope_of_square(p, i), db = slope_of_square(p, i + 1), rise = (b - a) / h;
	Piece piece = {p[i].v,
		       p[i + 1].v,
		       {a, da, (3 * rise - 2 * da - db) / h, (da + db - 2 * rise) / (h * h)},
		       0};
	piece.largest = largest_square(&piece);
	return piece;
}

const void *sor_create(Arena *arena, const SorDesc *desc, const char **error)
{
	const Vec2 *p = desc->points;
	*error = desc->point_count < 4 ? "a sor needs at least four points" : NULL;
	for (int i = 1; !*error && i + 2 < desc->point_count; i++) {
		if (!(p[i + 1].v > p[i].v))
			*error = "the heights of a sor must rise";
	}
	if (!*error &&
	    (p[2].v == p[0].v || p[desc->point_count - 1].v == p[desc->point_count - 3].v))
		*error =
			"the end points of a sor must differ in height "
			"from their second neighbours";
	if (*error)
		return NULL;
	Sor *sor = ARENA_NEW(arena, Sor);
	sor->count = desc->point_count - 3;
	Piece *pieces = ARENA_ARRAY(arena, Piece, sor->count);
	double largest = 0;
	for (int i = 0; i < sor->count; i++) {
		pieces[i] = make_piece(p, i + 1);
		largest = fmax(largest, pieces[i].largest);
	}
	sor->pieces = pieces;
	sor->radius = sqrt(largest);
	if (!desc->open) {
		sor->cap_low2 = square_at(&pieces[0], pieces[0].low);
		sor->cap_high2 = square_at(&pieces[sor->count - 1], pieces[sor->count - 1].high);
	}
	return sor;
}

static double low_of(const Sor *sor) { return sor->pieces[0].low; }
static double high_of(const Sor *sor) { return sor->pieces[sor->count - 1].high; }

static bool sor_bounds(const void *data, Box3 *box)
{
	const Sor *sor = data;
	*box = (Box3){{-sor->radius, low_of(sor), -sor->radius},
		      {sor->radius, high_of(sor), sor->radius}};
	return true;
}

/* A ray on its way through the box around the whole. */
typedef struct Way {
	const Ray *ray;
	double range[2];
	double inverse; /* of its rise */
	double nearest; /* where it is nearest to the axis */
} Way;

static Way make_way(const Sor *sor, const Ray *ray)
{
	Vec3 o = ray->origin, d = ray->direction;
	double across = d.x * d.x + d.z * d.z;
	Way way = {ray, {ray->tmin, ray->tmax}, 1 / d.y, 0};
	ray_slabs_clip(-sor->radius, sor->radius, o.x, 1 / d.x, way.range);
	ray_slabs_clip(-sor->radius, sor->radius, o.z, 1 / d.z, way.range);
	if (across > 0)
		way.nearest = -(o.x * d.x + o.z * d.z) / across;
	return way;
}

/* Where the ray is in the box around a piece, if it is there as near to the axis as the piece; a
 * little wider, since roots are looked for strictly inside. */
static bool piece_range(const Piece *piece, const Way *way, double range[2])
{
	static const double rounding = 1e-9;
	const Ray *ray = way->ray;
	range[0] = way->range[0];
	range[1] = way->range[1];
	ray_slabs_clip(piece->low, piece->high, ray->origin.y, way->inverse, range);
	if (!(range[0] <= range[1]))
		return false;
	Vec3 p = ray_at(ray, real_min(real_max(way->nearest, range[0]), range[1]));
	if (p.x * p.x + p.z * p.z > (1 + rounding) * piece->largest)
		return false;
	double slack = rounding * (fabs(range[0]) + fabs(range[1]));
	range[0] = real_max(range[0] - slack, ray->tmin);
	range[1] = real_min(range[1] + slack, ray->tmax);
	return true;
}

static void cross_piece(const Shape *self, const Way *way, int number, HitList *out)
{
	const Sor *sor = self->data;
	const Piece *piece = &sor->pieces[number];
	const Ray *ray = way->ray;
	double range[2];
	if (!piece_range(piece, way, range))
		return;
	Vec3 o = ray->origin, d = ray->direction;
	double w = o.y - piece->low, dy = d.y;
	const double *f = piece->f;
	/* f(w + t dy) - (ox + t dx)^2 - (oz + t dz)^2 = 0 */
	double p[4] = {
		polynomial_eval(f, 3, w) - o.x * o.x - o.z * o.z,
		dy * (f[1] + w * (2 * f[2] + 3 * w * f[3])) - 2 * (o.x * d.x + o.z * d.z),
		dy * dy * (f[2] + 3 * w * f[3]) - d.x * d.x - d.z * d.z,
		dy * dy * dy * f[3],
	};
	double roots[3];
	int found = polynomial_roots(p, 3, range[0], range[1], roots);
	for (int i = 0; i < found; i++) {
		double y = o.y + roots[i] * dy;
		if (y >= piece->low && y < piece->high)
			hit_list_push(out, (Hit){roots[i], self, number, 0, 0});
	}
}

static void cross_cap(const Shape *self, const Ray *ray, int cap, HitList *out)
{
	const Sor *sor = self->data;
	double y = cap == CAP_LOW ? low_of(sor) : high_of(sor),
	       r2 = cap == CAP_LOW ? sor->cap_low2 : sor->cap_high2;
	double t = (y - ray->origin.y) / ray->direction.y;
	Vec3 p = ray_at(ray, t);
	if (t > ray->tmin && t < ray->tmax && p.x * p.x + p.z * p.z < r2)
		hit_list_push(out, (Hit){t, self, cap, 0, 0});
}

static void sor_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	const Sor *sor = self->data;
	const Way way = make_way(sor, ray);
	for (int i = 0; i < sor->count; i++)
		cross_piece(self, &way, i, out);
	if (ray->direction.y != 0) {
		cross_cap(self, ray, CAP_LOW, out);
		cross_cap(self, ray, CAP_HIGH, out);
	}
}

static const Piece *piece_at(const Sor *sor, double y)
{
	for (int i = 0; i < sor->count; i++) {
		if (y >= sor->pieces[i].low && y <= sor->pieces[i].high)
			return &sor->pieces[i];
	}
	return NULL;
}

static bool sor_inside(const void *data, Vec3 p)
{
	const Piece *piece = piece_at(data, p.y);
	return piece && p.x * p.x + p.z * p.z <= square_at(piece, p.y);
}

static Vec3 sor_normal(const void *data, const Hit *hit, Vec3 p)
{
	if (hit->part < 0)
		return vec3(0, hit->part == CAP_HIGH ? 1 : -1, 0);
	const Piece *piece = &((const Sor *)data)->pieces[hit->part];
	double w = p.y - piece->low;
	return vec3(p.x, -0.5 * (piece->f[1] + w * (2 * piece->f[2] + 3 * w * piece->f[3])), p.z);
}

/* As in POV-Ray v grows up the profile: by 1 on each end, and by 1 in equal parts over the pieces.
 */
static Vec2 sor_uv(const void *data, const Hit *hit, Vec3 p)
{
	const Sor *sor = data;
	double r2 = p.x * p.x + p.z * p.z;
	if (hit->part == CAP_LOW)
		return (Vec2){vec3_turn(p), sqrt(r2 / sor->cap_low2) - 1};
	if (hit->part == CAP_HIGH)
		return (Vec2){vec3_turn(p), 2 - sqrt(r2 / sor->cap_high2)};
	const Piece *piece = &sor->pieces[hit->part];
	double along = (p.y - piece->low) / (piece->high - piece->low);
	return (Vec2){vec3_turn(p), (hit->part + along) / sor->count};
}

/* The ends. */
static bool sor_flat_at(const void *data, const Hit *hit)
{
	(void)data;
	return hit->part < 0;
}

const ShapeClass sor_class = {
	.name = "sor",
	.bounds = sor_bounds,
	.intersect = sor_intersect,
	.inside = sor_inside,
	.normal = sor_normal,
	.flat_at = sor_flat_at,
	.uv = sor_uv,
};
