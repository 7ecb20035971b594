/* Prisms, lathes, surfaces of revolution, text, height fields, polygons, meshes and patches. */
#include "geom/height_field.h"
#include "geom/mesh.h"
#include "geom/patch.h"
#include "geom/sweep.h"
#include "tests/unit/shape_check.h"

/* Rays that start anywhere: crossings and inside() must take turns, normals must point along a
 * change of inside(). */
enum { SHAPE_CHECK_RAYS = 2000 };

static Vec3 random_in_box(Sampler *s, Box3 box, double widen)
{
	Vec3 size = vec3_sub(box.hi, box.lo), p;
	p.x = box.lo.x + size.x * (sampler_next(s) * (1 + 2 * widen) - widen);
	p.y = box.lo.y + size.y * (sampler_next(s) * (1 + 2 * widen) - widen);
	p.z = box.lo.z + size.z * (sampler_next(s) * (1 + 2 * widen) - widen);
	return p;
}

/* For solids: between neighbouring crossings everything is inside or everything is outside, in
 * turns. Counts the rays where that fails: a few may graze an edge. */
static int check_alternation(const Shape *shape, const HitList *list, const Ray *ray)
{
	double previous = ray->tmin;
	bool inside = shape_inside(shape, ray_at(ray, ray->tmin));
	for (int i = 0; i <= list->count; i++) {
		double t = i < list->count ? list->hits[i].t : ray->tmax;
		if (shape_inside(shape, ray_at(ray, 0.5 * (previous + t))) != inside)
			return 1;
		inside = !inside;
		previous = t;
	}
	return 0;
}

static int check_normals(const Shape *shape, const HitList *list, const Ray *ray, double step)
{
	int wrong = 0;
	for (int i = 0; i < list->count; i++) {
		Vec3 p = ray_at(ray, list->hits[i].t), n = hit_normal(&list->hits[i], p);
		CHECK_NEAR(vec3_length(n), 1, 1e-9);
		wrong += shape_inside(shape, vec3_mad(p, step, n)) ||
			 !shape_inside(shape, vec3_mad(p, -step, n));
	}
	return wrong;
}

/* Rays from outside of the box through it. allowed: the share of rays and hits that may fail. */
static void check_solid(const Shape *shape, const char *name, double allowed)
{
	Sampler s = {11, 0, 0};
	int turns = 0, normals = 0, hits = 0, nearest = 0, ends = 0;
	double size = vec3_distance(shape->box.lo, shape->box.hi);
	for (int i = 0; i < SHAPE_CHECK_RAYS; i++) {
		Vec3 through = random_in_box(&s, shape->box, 0),
		     from = random_in_box(&s, shape->box, 2);
		Ray ray = {from, vec3_normalize(vec3_sub(through, from)), 0, 6 * size};
		HitList list;
		hit_list_init(&list);
		shape_intersect(shape, &ray, &list);
		hit_list_sort(&list);
		turns += check_alternation(shape, &list, &ray);
		normals += check_normals(shape, &list, &ray, 1e-6 * size);
		hits += list.count;
		nearest += test_nearest(shape, &ray, &list);
		ends += test_ends(shape, &ray, &list, 1e-9 * size);
		hit_list_free(&list);
	}
	if (hits < SHAPE_CHECK_RAYS / 4 || turns > allowed * SHAPE_CHECK_RAYS ||
	    normals > allowed * hits || nearest + ends > 0) {
		check_failures++;
		printf("%s: %d hits, %d rays out of turn, %d wrong normals, "
		       "%d wrong nearest hits, %d wrong where they are cut\n",
		       name, hits, turns, normals, nearest, ends);
	}
}

static const Vec2 star[] = {{0, 3},     {1, 1},  {3, 0.5}, {1.2, -0.5}, {2, -3}, {0, -1},
			    {-2, -2.5}, {-1, 0}, {-3, 1},  {-0.8, 1},   {0, 3}};
static const Vec2 with_hole[] = {{0, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 0},
				 {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}};
static const Vec2 round_curve[] = {{-1, 0}, {0, 1}, {1, 0}, {0, -1}, {-1, 0}, {0, 1}, {1, 0}};
static const Vec2 bezier[] = {{0, 1},   {0.5, 1}, {1, 0.5}, {1, 0},    {1, 0},    {1, -2},
			      {-1, -2}, {-1, 0},  {-1, 0},  {-1, 0.5}, {-0.5, 1}, {0, 1}};

static void test_prism(Arena *arena)
{
	const char *error;
	PrismDesc descs[] = {
		{CURVE_LINEAR, false, false, -1, 2, star, 11},
		{CURVE_LINEAR, true, false, 0.2, 1, with_hole, 10},
		{CURVE_LINEAR, true, false, -1, 1, star, 11},
		{CURVE_CUBIC, false, false, 0, 1, round_curve, 7},
		{CURVE_QUADRATIC, false, false, 0, 1, round_curve, 6},
		{CURVE_BEZIER, false, false, 0, 1, bezier, 12},
		{CURVE_BEZIER, true, false, 0.1, 1, bezier, 12},
	};
	const char *names[] = {"star prism",        "conic prism with a hole", "double cone",
			       "cubic prism",       "quadratic prism",         "bezier prism",
			       "conic bezier prism"};
	for (int i = 0; i < 7; i++) {
		Shape shape = test_shape(&prism_class, prism_create(arena, &descs[i], &error));
		CHECK(shape.data);
		if (shape.data)
			check_solid(&shape, names[i], 0.005);
	}
	Ray across = {{-9, 0.5, 0.1}, {1, 0, 0}, 0, 100}, up = {{0.1, -9, 0.2}, {0, 1, 0}, 0, 100};
	for (int i = 0; i < 7; i += 5) {
		Shape shape = test_shape(&prism_class, prism_create(arena, &descs[i], &error));
		check_flat(&shape, across, i ? "cc" : "ff");
		check_flat(&shape, up, "ff");
	}
	PrismDesc open = {CURVE_LINEAR, false, false, 0, 1, star, 9};
	CHECK(!prism_create(arena, &open, &error) && error);
}

/* However slowly a ray rises: into a cone of radius 1 - y / 2, out on the other side. */
static void test_lathe_rise(const Shape *cone)
{
	for (int i = 1; i <= 14; i++) {
		double rise = pow(10, -i);
		Ray ray = {{-5, 0.5 - 4 * rise, 0}, {1, rise, 0}, 0, 100};
		HitList list;
		hit_list_init(&list);
		shape_intersect(cone, &ray, &list);
		hit_list_sort(&list);
		double half = 1 - 0.5 * ray.origin.y; /* the radius at the ray's start */
		CHECK(list.count == 2);
		CHECK_NEAR(list.hits[0].t, (5 - half) / (1 - 0.5 * rise), 1e-8);
		CHECK_NEAR(list.hits[1].t, (5 + half) / (1 + 0.5 * rise), 1e-8);
		hit_list_free(&list);
	}
}

/* u runs about the axis from x over z, as POV-Ray's. */
static void check_turn_uv(const Shape *shape, double y)
{
	static const struct { double x, z, u; } ways[] = {
		{1, 0, 0}, {0.6, 0.8, 0.14758362}, {0, 1, 0.25}, {-1, 0, 0.5}, {0, -1, 0.75}};
	for (int i = 0; i < 5; i++) {
		Ray ray = {{9 * ways[i].x, y, 9 * ways[i].z}, {-ways[i].x, 0, -ways[i].z}, 0, 9};
		Hit hit;
		CHECK(shape_nearest(shape, &ray, &hit));
		CHECK_NEAR(hit_uv(&hit, ray_at(&ray, hit.t)).u, ways[i].u, 1e-8);
	}
}

/* A linear lathe around a triangle profile is a cone: the distance is known. */
static void test_lathe(Arena *arena)
{
	const char *error;
	static const Vec2 cone[] = {{0, 0}, {1, 0}, {0, 2}},
			  glass[] = {{1, -1},  {0, 0},   {1.2, 0.3}, {0.4, 1},
				     {0.9, 2}, {0, 2.2}, {-1, 2}};
	LatheDesc descs[] = {
		{CURVE_LINEAR, cone, 3}, {CURVE_CUBIC, glass, 7}, {CURVE_QUADRATIC, glass, 6}};
	const char *names[] = {"linear lathe", "cubic lathe", "quadratic lathe"};
	for (int i = 0; i < 3; i++) {
		Shape shape = test_shape(&lathe_class, lathe_create(arena, &descs[i], &error));
		check_solid(&shape, names[i], 0.005);
	}
	Shape shape = test_shape(&lathe_class, lathe_create(arena, &descs[0], &error));
	Hit hit;
	Ray side = {{-5, 1, 0}, {1, 0, 0}, 0, 100}, down = {{0.25, 9, 0}, {0, -1, 0}, 0, 100};
	CHECK(shape_nearest(&shape, &side, &hit));
	CHECK_NEAR(hit.t, 4.5, 1e-9);
	CHECK(shape_nearest(&shape, &down, &hit));
	CHECK_NEAR(hit.t, 7.5, 1e-9);
	test_lathe_rise(&shape);
	check_turn_uv(&shape, 1);
	LatheDesc tube = {CURVE_LINEAR, cone + 1, 2};
	Shape open = test_shape(&lathe_class, lathe_create(arena, &tube, &error));
	CHECK(shape.closed && !open.closed);
}

/* v as measured from POV-Ray's pictures: pieces from 0 to 0.5, 1.5 and 2, and ends. */
static void check_sor_v(const Shape *shape)
{
	static const struct { Ray ray; double v; } rows[] = {
		{{{9, 0.1, 0}, {-1, 0, 0}, 0, 9}, 0.2 / 3},
		{{{9, 1, 0}, {-1, 0, 0}, 0, 9}, 1.5 / 3},
		{{{9, 1.9, 0}, {-1, 0, 0}, 0, 9}, 2.8 / 3},
		{{{0.5, -1, 0}, {0, 1, 0}, 0, 9}, -0.5},
		{{{0.2, 9, 0}, {0, -1, 0}, 0, 9}, 1.75},
	};
	for (int i = 0; i < 5; i++) {
		Hit hit;
		CHECK(shape_nearest(shape, &rows[i].ray, &hit));
		CHECK_NEAR(hit_uv(&hit, ray_at(&rows[i].ray, hit.t)).v, rows[i].v, 1e-8);
	}
}

static void test_sor(Arena *arena)
{
	const char *error;
	static const Vec2 vase[] = {{1, -1}, {1, 0}, {1.5, 0.5}, {0.5, 1.5}, {0.8, 2}, {1, 3}},
			  falling[] = {{1, 0}, {1, 1}, {1, 0.5}, {1, 2}};
	SorDesc closed = {vase, 6, false}, wrong = {falling, 4, false}, few = {vase, 3, false};
	Shape shape = test_shape(&sor_class, sor_create(arena, &closed, &error));
	check_solid(&shape, "sor", 0.005);
	check_flat(&shape, (Ray){{0.1, -9, 0}, {0, 1, 0}, 0, 100}, "ff");
	check_flat(&shape, (Ray){{-9, 1, 0}, {1, 0, 0}, 0, 100}, "cc");
	check_turn_uv(&shape, 0.5);
	check_sor_v(&shape);
	CHECK(!sor_create(arena, &wrong, &error) && error);
	CHECK(!sor_create(arena, &few, &error) && error);
	Hit hit;
	Ray ray = {{-9, 0.5, 0}, {1, 0, 0}, 0, 100};
	CHECK(shape_nearest(&shape, &ray, &hit));
	CHECK_NEAR(hit.t, 9 - 1.5, 1e-9);
}

static void test_height_field(Arena *arena)
{
	enum { N = 37, M = 22 };
	static float heights[N * M];
	for (int i = 0; i < N * M; i++)
		heights[i] = (float)(0.4 + 0.3 * random_uniform(1, (uint64_t)i, 0));
	const char *error;
	HeightFieldDesc desc = {N, M, heights, false, 0};
	Shape shape = test_shape(&height_field_class, height_field_create(arena, &desc, &error));
	Sampler s = {5, 0, 0};
	/* from above every ray that ends below the lowest height crosses once more down than up */
	for (int i = 0; i < 2000; i++) {
		Vec3 from = vec3(sampler_next(&s), 1, sampler_next(&s)),
		     to = vec3(sampler_next(&s), 0, sampler_next(&s));
		Ray ray = {from, vec3_sub(to, from), 0, 1};
		HitList list;
		hit_list_init(&list);
		shape_intersect(&shape, &ray, &list);
		hit_list_sort(&list);
		CHECK(list.count % 2 == 1 && check_alternation(&shape, &list, &ray) == 0);
		hit_list_free(&list);
	}
	/* a slope: the height is the plane's */
	static const float slope[4] = {0, 1, 0, 1};
	HeightFieldDesc plane = {2, 2, slope, true, 0.25};
	shape = test_shape(&smooth_height_field_class, height_field_create(arena, &plane, &error));
	Ray down = {{0.3, 5, 0.6}, {0, -1, 0}, 0, 10}, dry = {{0.2, 5, 0.6}, {0, -1, 0}, 0, 10};
	Hit hit;
	CHECK(shape_nearest(&shape, &down, &hit));
	CHECK_NEAR(hit.t, 4.7, 1e-7);
	CHECK_NEAR(hit_shading_normal(&hit, ray_at(&down, hit.t)).x, -sqrt(0.5), 1e-7);
	CHECK(!shape_nearest(&shape, &dry, &hit));
	plane.width = 1;
	CHECK(!height_field_create(arena, &plane, &error));
}

static void test_polygon(Arena *arena)
{
	const char *error;
	Vec3 points[10];
	for (int i = 0; i < 10; i++)
		points[i] = vec3(with_hole[i].u, with_hole[i].v, with_hole[i].u + 1);
	Shape shape = test_shape(&polygon_class, polygon_create(arena, points, 10, &error));
	Hit hit;
	Ray through = {{0.5, 0.5, -5}, {0, 0, 1}, 0, 100},
	    hole = {{1.5, 1.5, -5}, {0, 0, 1}, 0, 100};
	CHECK(shape_nearest(&shape, &through, &hit));
	CHECK_NEAR(hit.t, 6.5, 1e-12);
	CHECK(!shape_nearest(&shape, &hole, &hit));
	points[3].z += 1;
	CHECK(!polygon_create(arena, points, 10, &error) && error);
	CHECK(!polygon_create(arena, points, 2, &error) && error);
}

/* A unit octahedron: inside is |x| + |y| + |z| < 1. */
static void test_mesh(Arena *arena)
{
	static const float v[6][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
				      {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
	static const int t[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
				    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
	MeshDesc desc = {.vertices = v,
			 .vertex_count = 6,
			 .triangles = t,
			 .triangle_count = 8,
			 .normals = v,
			 .normal_count = 6,
			 .has_inside_vector = true,
			 .inside_vector = {0.1, 1, 0.2}};
	const char *error;
	Shape shape = test_shape(&mesh_class, mesh_create(arena, &desc, &error));
	check_solid(&shape, "mesh", 0.002);
	CHECK(shape_inside(&shape, vec3(0.3, 0.3, 0.3)) &&
	      !shape_inside(&shape, vec3(0.4, 0.4, 0.4)));
	Ray ray = {{3, 3, 3}, {-1, -1, -1}, 0, 100};
	Hit hit;
	CHECK(shape_nearest(&shape, &ray, &hit));
	CHECK_NEAR(hit.t, 3 - 1.0 / 3, 1e-7);
	CHECK_NEAR(hit_shading_normal(&hit, ray_at(&ray, hit.t)).x, sqrt(1.0 / 3), 1e-7);
	static const int wrong[1][3] = {{0, 1, 6}};
	desc.triangles = wrong;
	desc.triangle_count = 1;
	CHECK(!mesh_create(arena, &desc, &error) && error);
}

static void test_patch(Arena *arena)
{
	PatchDesc desc = {.u_steps = 4, .v_steps = 4};
	for (int i = 0; i < 16;
	     i++) /* Bezier control points of z = x^2 over the unit square, as x = j / 3 */
		desc.control[i] = vec3((i % 4) / 3.0, (i / 4) / 3.0,
				       (double[]){0, 0, 1.0 / 3, 1}[i % 4]);
	Shape shape = test_shape(&mesh_class, bicubic_patch_create(arena, &desc));
	Ray ray = {{0.53, 0.41, -1}, {0, 0, 1}, 0, 10};
	Hit hit;
	CHECK(shape_nearest(&shape, &ray, &hit));
	CHECK_NEAR(hit.t, 1 + 0.53 * 0.53,
		   1e-3); /* 16 chords miss the parabola by at most 1/1024 */
	CHECK_NEAR(hit_uv(&hit, ray_at(&ray, hit.t)).u, 0.53, 1e-6);
	Vec3 n = hit_shading_normal(&hit, ray_at(&ray, hit.t));
	CHECK_NEAR(fabs(n.x / n.z), 2 * 0.53, 2e-2);
}

static void test_text(Arena *arena, const char *font)
{
	const char *error;
	TextDesc desc = {font, "Og8", 0.5, {0, 0}}, none = {"/nowhere.ttf", "a", 1, {0, 0}};
	CHECK(!text_create(arena, &none, &error) && error);
	FILE *file = fopen(font, "rb");
	if (!file) {
		printf("no font %s: text is not tested\n", font);
		return;
	}
	fclose(file);
	Shape shape = test_shape(&text_class, text_create(arena, &desc, &error));
	check_solid(&shape, "text", 0.005);
	Ray through = {{0.1, 0.35, -9}, {0, 0, 1}, 0, 100};
	check_flat(&shape, through, "ff");
	check_flat(&shape, (Ray){{-9, 0.35, 0.2}, {1, 0, 0}, 0, 9.5}, "cc");
	CHECK_NEAR(shape.box.lo.z, 0, 1e-6);
	CHECK_NEAR(shape.box.hi.z, 0.5, 1e-6);
	CHECK(shape.box.hi.x > 1.8 && shape.box.hi.x < 2.2); /* three letters of some 0.65 em */
}

int main(void)
{
	Arena *arena = arena_create();
	test_prism(arena);
	test_lathe(arena);
	test_sor(arena);
	test_height_field(arena);
	test_polygon(arena);
	test_mesh(arena);
	test_patch(arena);
	test_text(arena, "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf");
	arena_destroy(arena);
	return CHECK_RESULT();
}
