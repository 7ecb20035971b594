/* Walking nodes: what is taken, what is reported, and where the walk goes on after a mistake. */
#include "lang/cursor.h"

#include <stdlib.h>

#include "check.h"

static Context context;

static Node value(Value v) { return (Node){.kind = NODE_VALUE, .value = v}; }

static Node word(Word w) { return (Node){.kind = NODE_WORD, .word = w}; }

/* Chains the nodes into a sphere's block. */
static Node block(Node *nodes, int count)
{
	for (int i = 0; i + 1 < count; i++)
		nodes[i].next = &nodes[i + 1];
	return (Node){.kind = NODE_BLOCK, .word = W_sphere, .children = nodes};
}

static void test_takes(void)
{
	Node nodes[] = {value(value_float(2)),   word(W_hollow), word(W_phong),
			value(value_float(0.5)), word(W_hollow), value(value_float(0))};
	Node all = block(nodes, 6);
	Cursor cursor = cursor_begin(&context, &all);
	Vec3 v;
	double number = 0;
	CHECK(cursor_take_vec3(&cursor, &v) && v.z == 2);
	CHECK(!cursor_accept_word(&cursor, W_phong));
	CHECK(cursor_accept_word(&cursor, W_hollow) && cursor_optional_bool(&cursor));
	CHECK(cursor_accept_word(&cursor, W_phong) && cursor_take_float(&cursor, &number) &&
	      number == 0.5);
	CHECK(cursor_accept_word(&cursor, W_hollow) && !cursor_optional_bool(&cursor));
	CHECK(cursor_end(&cursor));
	CHECK(diag_errors(context.diag) == 0);
}

static void test_floats_from_vectors(void)
{
	Node nodes[] = {value(value_vec3(vec3(1, 2, 3))), value(value_float(4)),
			value(value_vec3(vec3(5, 6, 7)))};
	Node all = block(nodes, 3);
	Cursor cursor = cursor_begin(&context, &all);
	double out[7];
	CHECK(cursor_take_floats(&cursor, out, 7) && out[0] == 1 && out[3] == 4 && out[6] == 7);
	CHECK(cursor_at_end(&cursor));
}

/* The mistake is reported once; the walk goes on at the next word. */
static void test_recovers(void)
{
	Node nodes[] = {word(W_phong), value(value_string("no")), value(value_float(1)),
			word(W_hollow)};
	Node all = block(nodes, 4);
	Cursor cursor = cursor_begin(&context, &all);
	double number = 7;
	int before = diag_errors(context.diag);
	CHECK(cursor_accept_word(&cursor, W_phong) && !cursor_take_float(&cursor, &number));
	CHECK(number == 7);
	CHECK(diag_errors(context.diag) == before + 1);
	CHECK(cursor_peek_word(&cursor) == W_hollow);
	CHECK(!cursor_end(&cursor));
	CHECK(diag_errors(context.diag) == before + 2);
}

static void test_messages(void)
{
	Node nodes[] = {word(W_phong), value(value_string("no"))};
	Node all = block(nodes, 2);
	char text[400] = "";
	FILE *out = tmpfile();
	if (!out)
		return;
	Diag *quiet = context.diag;
	context.diag = diag_create(out);
	Cursor cursor = cursor_begin(&context, &all);
	double number;
	cursor_accept_word(&cursor, W_phong);
	cursor_take_float(&cursor, &number);
	cursor_take_float(&cursor, &number);
	rewind(out);
	CHECK(fread(text, 1, sizeof text - 1, out) > 0);
	CHECK(strstr(text, "expected a float after 'phong', found a string") != NULL);
	CHECK(strstr(text, "expected a float after 'phong', found '}'") != NULL);
	diag_destroy(context.diag);
	context.diag = quiet;
	fclose(out);
}

int main(void)
{
	context.diag = diag_create(NULL);
	context.items = arena_create();
	test_takes();
	test_floats_from_vectors();
	test_recovers();
	test_messages();
	arena_destroy(context.items);
	diag_destroy(context.diag);
	return CHECK_RESULT();
}
