/*
 * The camera's frame from its words. Expected numbers follow POV-Ray 3.7, whose images do not
 * change when the words of a camera change places: angle sets the distance from the final right
 * vector, then look_at turns, then transformations move.
 */
#include "lang/build_camera.h"

#include "check.h"
#include "lang/cursor.h"

static Context context;
static SceneBuilder builder;
static Camera plain;

static Node vector(double x, double y, double z)
{
	return (Node){.kind = NODE_VALUE, .value = value_vec3(vec3(x, y, z))};
}

static Node number(double x) { return (Node){.kind = NODE_VALUE, .value = value_float(x)}; }

static Node word(Word w) { return (Node){.kind = NODE_WORD, .word = w}; }

static Camera build(Node *nodes, int count)
{
	for (int i = 0; i + 1 < count; i++)
		nodes[i].next = &nodes[i + 1];
	Node all = {.kind = NODE_BLOCK, .word = W_camera, .children = nodes};
	return *build_camera(&context, &all, &plain);
}

#define BUILD(nodes) build(nodes, (int)(sizeof(nodes) / sizeof *(nodes)))

static void check_vector(Vec3 v, double x, double y, double z)
{
	CHECK_NEAR(v.x, x, 1e-9);
	CHECK_NEAR(v.y, y, 1e-9);
	CHECK_NEAR(v.z, z, 1e-9);
}

static void test_order_does_not_count(void)
{
	Node first[] = {word(W_angle),   number(90),    word(W_look_at),
			vector(5, 0, 0), word(W_right), vector(2, 0, 0)};
	Node second[] = {word(W_right), vector(2, 0, 0), word(W_angle),
			 number(90),    word(W_look_at), vector(5, 0, 0)};
	Camera a = BUILD(first), b = BUILD(second);
	check_vector(a.direction, 1, 0, 0); /* 0.5 * 2 / tan 45 */
	check_vector(a.right, 0, 0, -2);
	check_vector(a.up, 0, 1, 0);
	check_vector(b.direction, a.direction.x, a.direction.y, a.direction.z);
	check_vector(b.right, a.right.x, a.right.y, a.right.z);
}

static void test_transform_comes_last(void)
{
	Node nodes[] = {word(W_location), vector(0, 0, -4), word(W_rotate),
			vector(0, 90, 0), word(W_look_at),  vector(0, 0, 0)};
	Camera camera = BUILD(nodes);
	check_vector(camera.location, -4, 0, 0);
	check_vector(camera.direction, 1, 0, 0);
}

static void test_handedness_stays(void)
{
	Node nodes[] = {word(W_right), vector(-1.5, 0, 0), word(W_look_at), vector(0, 0, 3)};
	Camera camera = BUILD(nodes);
	check_vector(camera.right, -1.5, 0, 0);
	check_vector(camera.up, 0, 1, 0);
}

static void test_straight_down(void)
{
	Node nodes[] = {word(W_location), vector(0, 5, 0), word(W_look_at), vector(0, 0, 0)};
	Camera camera = BUILD(nodes);
	check_vector(camera.direction, 0, -1, 0);
	check_vector(camera.up, 0, 0, 1);
	check_vector(camera.right, 1.33, 0, 0);
}

/* As wide as a perspective camera sees at look_at, unless up or right say how wide. */
static void test_orthographic_size(void)
{
	Node free[] = {word(W_orthographic), word(W_location), vector(0, 0, -8), word(W_look_at),
		       vector(0, 0, 0)};
	Camera camera = BUILD(free);
	check_vector(camera.right, 1.33 * 8, 0, 0);
	check_vector(camera.up, 0, 8, 0);
	Node sized[] = {word(W_orthographic), word(W_location), vector(0, 0, -8), word(W_up),
			vector(0, 3, 0)};
	camera = BUILD(sized);
	check_vector(camera.right, 1.33, 0, 0);
	check_vector(camera.up, 0, 3, 0);
	Node angled[] = {word(W_orthographic), word(W_angle),   number(90),
			 word(W_right),        vector(2, 0, 0), word(W_location),
			 vector(0, 0, -8),     word(W_look_at), vector(0, 0, 0)};
	camera = BUILD(angled);
	check_vector(camera.right, 16, 0, 0);
}

static void test_focal_distance(void)
{
	Node nodes[] = {word(W_location), vector(0, 0, -4),  word(W_focal_point),
			vector(3, 0, 0),  word(W_translate), vector(9, 9, 9)};
	CHECK_NEAR(BUILD(nodes).focal_distance, 5, 1e-12);
}

int main(void)
{
	builder.arena = arena_create();
	context.builder = &builder;
	context.diag = diag_create(NULL);
	context.items = builder.arena;
	plain = camera_default(1.33);
	context.defaults.camera = &plain;
	test_order_does_not_count();
	test_transform_comes_last();
	test_handedness_stays();
	test_straight_down();
	test_orthographic_size();
	test_focal_distance();
	CHECK(diag_errors(context.diag) == 0);
	arena_destroy(builder.arena);
	diag_destroy(context.diag);
	return CHECK_RESULT();
}
