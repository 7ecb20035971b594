/* CSG: analytic intervals, De Morgan's laws under inversion, and many children. */
#include "geom/csg.h"

#include "geom/box.h"
#include "geom/cone.h"
#include "geom/plane.h"
#include "geom/poly.h"
#include "geom/ray_box.h"
#include "geom/sphere.h"
#include "tests/unit/shape_check.h"

static const char *message;

static Shape *new_shape(Arena *arena, const ShapeClass *class, const void *data)
{
	Shape *shape = ARENA_NEW(arena, Shape);
	*shape = test_shape(class, data);
	return shape;
}

static Shape *new_sphere(Arena *arena, Vec3 center, double radius)
{
	return new_shape(arena, &sphere_class, sphere_create(arena, center, radius));
}

static Shape *new_csg(Arena *arena, const ShapeClass *class, const Shape *a, const Shape *b)
{
	const Shape **children = ARENA_ARRAY(arena, const Shape *, 2);
	children[0] = a;
	children[1] = b;
	return new_shape(arena, class, csg_create(arena, children, 2));
}

static Shape *new_inverse(Arena *arena, const Shape *shape)
{
	Shape *copy = arena_copy(arena, shape, sizeof(*shape));
	copy->inverted = !copy->inverted;
	shape_finish(copy);
	return copy;
}

/* Crossings along the x axis from x = -10. */
static void check_axis(const Shape *shape, const double *expected, int count)
{
	Ray ray = {{-10, 0, 0}, {1, 0, 0}, 0, INFINITY};
	HitList list;
	hit_list_init(&list);
	shape_intersect(shape, &ray, &list);
	hit_list_sort(&list);
	CHECK(list.count == count);
	for (int i = 0; i < count && i < list.count; i++)
		CHECK_NEAR(list.hits[i].t - 10, expected[i], 1e-12);
	Hit hit;
	CHECK(shape_nearest(shape, &ray, &hit) == (count > 0));
	if (count > 0)
		CHECK_NEAR(hit.t - 10, expected[0], 1e-12);
	hit_list_free(&list);
}

static void test_operations(Arena *arena)
{
	Shape *a = new_sphere(arena, vec3(0, 0, 0), 2), *b = new_sphere(arena, vec3(1, 0, 0), 2);
	check_axis(new_csg(arena, &csg_union_class, a, b), (double[]){-2, -1, 2, 3}, 4);
	check_axis(new_csg(arena, &csg_merge_class, a, b), (double[]){-2, 3}, 2);
	check_axis(new_csg(arena, &csg_intersection_class, a, b), (double[]){-1, 2}, 2);
	Shape *difference = new_csg(arena, &csg_intersection_class, a, new_inverse(arena, b));
	check_axis(difference, (double[]){-2, -1}, 2);
	CHECK_NEAR(difference->box.hi.x, 2, 1e-6);
	/* The cut surface belongs to the inverted child and points out of the whole. */
	Ray ray = {{0, 0, 0}, {-1, 0, 0}, 0, INFINITY};
	Hit hit;
	CHECK(shape_nearest(difference, &ray, &hit));
	CHECK_NEAR(hit_normal(&hit, ray_at(&ray, hit.t)).x, 1, 1e-12);
	Shape *lens = new_csg(arena, &csg_intersection_class, a, b);
	CHECK_NEAR(lens->box.lo.x, -1, 1e-6);
	CHECK_NEAR(lens->box.hi.x, 2, 1e-6);
}

/* inverse(union) is the intersection of inverses; the flag and the deep copy must agree. */
static void test_inversion(Arena *arena)
{
	Shape *a = new_sphere(arena, vec3(0, 0, 0), 2), *b = new_sphere(arena, vec3(1, 0, 0), 2);
	Shape *big = new_sphere(arena, vec3(0, 0, 0), 5);
	const ShapeClass *classes[] = {&csg_union_class, &csg_merge_class, &csg_intersection_class};
	const double cut[3][6] = {{-5, -2, 3, 5}, {-5, -2, 3, 5}, {-5, -1, 2, 5}};
	for (int i = 0; i < 3; i++) {
		Shape *hole = new_csg(arena, classes[i], a, b);
		Shape *flagged = new_csg(arena, &csg_intersection_class, big,
					 new_inverse(arena, hole));
		const Shape *copy = new_csg(arena, &csg_intersection_class, big,
					    csg_invert(arena, hole));
		check_axis(flagged, cut[i], 4);
		check_axis(copy, cut[i], 4);
		CHECK(flagged->box.hi.x < 5.1 && copy->box.hi.x < 5.1);
		for (int n = 0; n < 500; n++) {
			Sampler sampler = {3, (uint64_t)n, 0};
			Vec3 p = test_point(&sampler, 4);
			CHECK(shape_inside(flagged, p) == shape_inside(copy, p));
			CHECK(shape_inside(new_inverse(arena, hole), p) != shape_inside(hole, p));
		}
		check_shape(copy,
			    &(ShapeTraits){
				    .name = "inverted csg", .size = 5, .step = 1e-6, .fixed = true},
			    500);
	}
}

/* A block with a grid of holes: the tree must find what a plain list of children finds. */
static void test_many_children(Arena *arena)
{
	enum { SIDE = 8, COUNT = SIDE * SIDE };
	const Shape **holes = ARENA_ARRAY(arena, const Shape *, COUNT);
	for (int i = 0; i < COUNT; i++)
		holes[i] = new_sphere(arena, vec3(i % SIDE - 3.5, i / SIDE - 3.5, 1), 0.45);
	Csg plain = {.children = holes, .count = COUNT};
	Shape *with_tree = new_shape(arena, &csg_union_class, csg_create(arena, holes, COUNT));
	Shape *without = new_shape(arena, &csg_union_class, &plain);
	Shape *block = new_shape(arena, &box_class,
				 box_create(arena, vec3(-4, -4, -1), vec3(4, 4, 1)));
	Shape *one = new_csg(arena, &csg_intersection_class, block, new_inverse(arena, with_tree));
	Shape *other = new_csg(arena, &csg_intersection_class, block, new_inverse(arena, without));
	for (int n = 0; n < 2000; n++) {
		Sampler sampler = {5, (uint64_t)n, 0};
		Ray ray = test_ray(&sampler, 4);
		Hit a, b;
		bool found = shape_nearest(one, &ray, &a);
		CHECK(shape_nearest(other, &ray, &b) == found);
		CHECK(!found || (a.t == b.t && a.shape == b.shape));
	}
	const Shape *drilled = new_csg(arena, &csg_intersection_class, block,
				       csg_invert(arena, with_tree));
	check_shape(
		drilled,
		&(ShapeTraits){.name = "block with holes", .size = 4, .step = 1e-6, .fixed = true},
		1000);
	const Shape *deep = csg_invert(arena, csg_invert(arena, drilled));
	check_shape(
		deep,
		&(ShapeTraits){.name = "inverted twice", .size = 4, .step = 1e-6, .fixed = true},
		1000);
}

static void test_nested(Arena *arena)
{
	Shape *shell = new_csg(arena, &csg_intersection_class, new_sphere(arena, vec3_all(0), 3),
	                       new_inverse(arena, new_sphere(arena, vec3_all(0), 2)));
	Shape *half = new_shape(arena, &plane_class,
				plane_create(arena, vec3(1, 0, 0), 0.5, &message));
	check_axis(new_csg(arena, &csg_intersection_class, shell, half), (double[]){-3, -2}, 2);
	Shape *rest = new_csg(arena, &csg_intersection_class, new_sphere(arena, vec3_all(0), 4),
			      csg_invert(arena, shell));
	check_axis(rest, (double[]){-4, -3, -2, 2, 3, 4}, 6);
	check_shape(rest, &(ShapeTraits){.name = "nested", .size = 4, .step = 1e-6, .fixed = true},
		    1000);
}

static Shape *new_plane(Arena *arena, Vec3 normal, double distance)
{
	return new_shape(arena, &plane_class, plane_create(arena, normal, distance, &message));
}

/* A hyperboloid x^2 - y^2 + z^2 = 1 between two planes: none is bounded, all together are. */
static void test_cut_bounds(Arena *arena)
{
	const double waist[10] = {1, -1, 1, 0, 0, 0, 0, 0, 0, -1};
	Shape *quadric = new_shape(arena, &quadric_class, quadric_create(arena, waist));
	Shape *top = new_plane(arena, vec3(0, 1, 0), 2),
	      *bottom = new_plane(arena, vec3(0, -1, 0), 1);
	Shape *ends = new_csg(arena, &csg_intersection_class, top, bottom);
	CHECK(!shape_is_bounded(ends));
	Shape *both = new_csg(arena, &csg_intersection_class, quadric, ends);
	CHECK(shape_is_bounded(both));
	CHECK_NEAR(both->box.lo.y, -1, 1e-8);
	CHECK_NEAR(both->box.hi.y, 2, 1e-8);
	CHECK_NEAR(both->box.lo.x, -sqrt(5), 1e-8);
	CHECK_NEAR(both->box.hi.z, sqrt(5), 1e-8);
	check_shape(both, &(ShapeTraits){.name = "waist", .size = 3, .step = 1e-6, .fixed = true},
		    1000);
	CHECK(!shape_is_bounded(
		new_csg(arena, &csg_intersection_class, new_inverse(arena, quadric), ends)));
}

/* A class with the transform in its data gives the crossings that the transform beside them gives.
 */
static void check_placed(Arena *arena, const Shape *plain, Transform transform)
{
	Shape beside = *plain, within = *plain;
	beside.transform = &transform;
	within.data = plain->class->placed(arena, plain->data, &transform);
	CHECK(within.data != NULL);
	shape_finish(&beside);
	shape_finish(&within);
	for (int i = 0; i < 40; i++) {
		Vec3 from = vec3(9 * cos(i), 9 * sin(i), 5 * cos(3 * i));
		Ray ray = {from, vec3_sub(vec3(1 + 0.1 * cos(7 * i), 2, 3), from), 0, INFINITY};
		Hit a, b;
		bool hit = shape_nearest(&beside, &ray, &a);
		CHECK(hit == shape_nearest(&within, &ray, &b));
		if (hit) {
			CHECK_NEAR(a.t, b.t, 1e-9);
			CHECK_NEAR(vec3_dot(hit_normal(&a, ray_at(&ray, a.t)),
					    hit_normal(&b, ray_at(&ray, b.t))),
				   1, 1e-9);
		}
		CHECK(shape_inside(&beside, from) == shape_inside(&within, from));
	}
}

static void test_placed(Arena *arena)
{
	const double bowl[10] = {1, 2, 0.5, 0.3, -0.2, 0.1, 0.4, 0, -1, -1};
	Transform turn = transform_rotate(vec3(20, 30, 40)),
		  stretch = transform_scale(vec3(1, 2, 0.7));
	Transform move = transform_translate(vec3(1, 2, 3)), even = transform_scale(vec3_all(1.5));
	Transform turned = transform_compose(&turn, &stretch),
		  upright = transform_compose(&stretch, &move);
	turned = transform_compose(&turned, &move);
	even = transform_compose(&even, &move);
	check_placed(arena, new_shape(arena, &quadric_class, quadric_create(arena, bowl)), turned);
	check_placed(arena, new_plane(arena, vec3(1, 2, -1), 0.5), turned);
	check_placed(arena, new_sphere(arena, vec3(0.1, 0, 0.2), 1), even);
	Shape *box = new_shape(arena, &box_class, box_create(arena, vec3_all(-1), vec3_all(0.9)));
	check_placed(arena, box, upright);
	CHECK(!box_class.placed(arena, box->data, &turned));
	CHECK(!sphere_class.placed(arena, new_sphere(arena, vec3_all(0), 1)->data, &upright));
}

static bool asked_bounds(const void *data, Box3 *box)
{
	(void)data;
	*box = (Box3){vec3_all(-2), vec3_all(2)};
	return true;
}

/* Counts how often it is asked, and has the plane y = 0's inside. */
static void asked_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	(void)ray;
	(void)out;
	++*(int *)self->data;
}

static bool asked_inside(const void *data, Vec3 p)
{
	(void)data;
	return p.y < 0;
}

static const ShapeClass asked_class = {
	.name = "asked",
	.bounds = asked_bounds,
	.intersect = asked_intersect,
	.inside = asked_inside,
};

static int times_asked(const Shape *whole, int *count, double height)
{
	Ray ray = {{-10, height, height}, {1, 0, 0}, 0, INFINITY};
	Hit hit;
	*count = 0;
	CHECK(!shape_nearest(whole, &ray, &hit));
	return *count;
}

/* Where a closed child leaves nothing, the others are not asked; a tube without ends says nothing
 * though no crossing shows that the ray is in it. */
static void test_nothing_left(Arena *arena)
{
	int count;
	Shape *ball = new_sphere(arena, vec3_all(0), 2),
	      *asked = new_shape(arena, &asked_class, &count);
	Shape *both = new_csg(arena, &csg_intersection_class, ball, asked);
	CHECK(times_asked(both, &count, 1.9) == 0);
	CHECK(times_asked(both, &count, 1) == 1);
	CHECK(times_asked(new_csg(arena, &csg_intersection_class, asked, ball), &count, 1.9) == 1);

	Shape *block = new_shape(arena, &box_class,
				 box_create(arena, vec3(-5, -0.5, -0.5), vec3(1, 0.5, 0.5)));
	for (int open = 0; open < 2; open++) {
		ConeDesc desc = {vec3(-3, 0, 0), vec3(3, 0, 0), 1, 1, open};
		Shape *tube =
			new_shape(arena, &cylinder_class, cone_create(arena, &desc, &message));
		CHECK(tube->closed == !open);
		check_axis(new_csg(arena, &csg_merge_class, tube, block), (double[]){-5, 3},
			   open ? 1 : 2);
		check_axis(new_csg(arena, &csg_merge_class, block, tube), (double[]){-5, 3},
			   open ? 1 : 2);
	}
}

/* Rays in the very plane of a side meet the box, on either of its sides; those beside it do not. */
static void test_slabs(void)
{
	Box3 box = {vec3(-1, -2, -3), vec3(1, 2, 3)};
	for (int axis = 0; axis < 3; axis++)
		for (int side = -1; side <= 1; side += 2) {
			double at[3] = {0, 0, 0}, toward[3] = {0, 0, 0};
			int along = (axis + 1) % 3;
			at[axis] = side * (axis + 1.0);
			at[along] = -10;
			toward[along] = 1;
			Ray ray = {vec3(at[0], at[1], at[2]),
				   vec3(toward[0], toward[1], toward[2]), 0, INFINITY};
			RaySlabs slabs = ray_slabs(&ray);
			CHECK(ray_slabs_hit(&slabs, &box));
			at[axis] *= 1.001;
			ray.origin = vec3(at[0], at[1], at[2]);
			slabs = ray_slabs(&ray);
			CHECK(!ray_slabs_hit(&slabs, &box));
		}
}

int main(void)
{
	Arena *arena = arena_create();
	test_operations(arena);
	test_inversion(arena);
	test_many_children(arena);
	test_nested(arena);
	test_cut_bounds(arena);
	test_placed(arena);
	test_nothing_left(arena);
	test_slabs();
	arena_destroy(arena);
	return CHECK_RESULT();
}
