#include "parser_stub.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "lang/build.h"
#include "lang/node_print.h"
#include "parser/reader.h"

static FILE *out; /* one test reads one scene at a time */

bool build_scene_item(Context *context, const Node *item)
{
	(void)context;
	node_print(out, item);
	putc('\n', out);
	return true;
}

static ValueKind kind_of(Word word)
{
	switch (word) {
	case W_texture: return VALUE_TEXTURE;
	case W_pigment: return VALUE_PIGMENT;
	case W_finish: return VALUE_FINISH;
	case W_transform: return VALUE_TRANSFORM;
	case W_color_map: return VALUE_COLOR_MAP;
	default: return VALUE_OBJECT;
	}
}

Value build_value(Context *context, const Node *items)
{
	(void)context;
	return value_item(kind_of(items->word), "");
}

void build_defaults(Context *context, const Node *items)
{
	(void)context;
	fputs("default: ", out);
	node_print(out, items);
	putc('\n', out);
}

void build_init(Context *context)
{
	(void)context;
}

char *parser_stub_read(const char *scene)
{
	char path[] = "parser_stub_XXXXXX", *text = NULL;
	size_t size;
	int file = mkstemp(path);
	if (file < 0 || write(file, scene, strlen(scene)) != (ssize_t)strlen(scene))
		return NULL;
	close(file);
	out = open_memstream(&text, &size);
	Diag *diag = diag_create(out);
	SceneBuilder builder = {.arena = arena_create(), .diag = diag};
	ReaderOptions options = {.path = path, .image_width = 160, .image_height = 120};
	if (!reader_read(&options, &builder, diag))
		fputs("failed\n", out);
	diag_destroy(diag);
	arena_destroy(builder.arena);
	fclose(out);
	unlink(path);
	return text;
}
