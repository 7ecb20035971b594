/* cognac-layer: what layers an OpenEXR picture has, and one of them as a PNG to look at. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "cli/tool.h"
#include "image/layer.h"
#include "image/write.h"

typedef struct Task {
	const char *picture, *layer, *output;
	LayerView view;
} Task;

static const char usage[] =
	"usage: cognac-layer [OPTION]... PICTURE.exr [LAYER]\n"
	"Draws a layer of an OpenEXR picture as PNG; without LAYER names the layers and their\n"
	"values' bounds.\n"
	"\n"
	"  -o, --output=FILE        the PNG; PICTURE.LAYER.png without it\n"
	"      --exposure=FACTOR    multiply light by this first\n"
	"      --range=LEAST,MOST   of the colour scale of layers of numbers\n"
	"      --unlit              do not shade layers of photons by the caustic\n"
	"      --help               print this and exit\n"
	"      --version            print the version and exit\n";

static bool list_layers(const ExrImage *exr)
{
	Arena *arena = arena_create();
	const char **names;
	int count = layer_names(exr, &names, arena);
	for (int i = 0; i < count; i++) {
		double least = 0, most = 0;
		Image *layer = layer_extract(exr, names[i]);
		if (layer && layer_bounds(layer, &least, &most))
			printf("%s %.6g %.6g\n", names[i], least, most);
		image_destroy(layer);
	}
	arena_destroy(arena);
	return fflush(stdout) == 0;
}

static const char *output_name(const Task *task, Arena *arena)
{
	const char *dot = strrchr(task->picture, '.'), *slash = strrchr(task->picture, '/');
	if (task->output)
		return task->output;
	size_t length = dot && (!slash || dot > slash) ? (size_t)(dot - task->picture)
						       : strlen(task->picture);
	return arena_printf(arena, "%.*s.%s.png", (int)length, task->picture, task->layer);
}

static bool write_layer(const Task *task, const ExrImage *exr, Diag *diag)
{
	Image *image = layer_draw(exr, task->layer, &task->view);
	if (!image) {
		diag_fail(diag, "%s: no layer %s", task->picture, task->layer);
		return false;
	}
	Arena *arena = arena_create();
	/* Values are what the screen shall show: linear to the writer, which then changes none. */
	ImageEncoding encoding = {.format = IMAGE_PNG, .bits = 8, .gamma = 0};
	bool good = image_write(output_name(task, arena), &encoding, image, diag);
	arena_destroy(arena);
	image_destroy(image);
	return good;
}

static bool run(void *data, char **operands, int count, Diag *diag)
{
	Task *task = data;
	task->picture = operands[0];
	task->layer = count > 1 ? operands[1] : NULL;
	ExrImage *exr = exr_read(task->picture, diag);
	bool good = exr && (task->layer ? write_layer(task, exr, diag) : list_layers(exr));
	exr_destroy(exr);
	return good;
}

enum { OPTION_EXPOSURE = 1, OPTION_RANGE, OPTION_UNLIT };

static const struct option options[] = {
	{"output", required_argument, NULL, 'o'},
	{"exposure", required_argument, NULL, OPTION_EXPOSURE},
	{"range", required_argument, NULL, OPTION_RANGE},
	{"unlit", no_argument, NULL, OPTION_UNLIT},
	TOOL_OPTIONS,
};

static bool read_exposure(const char *text, LayerView *view)
{
	char rest;
	return sscanf(text, "%lf%c", &view->exposure, &rest) == 1 && view->exposure > 0;
}

static bool read_range(const char *text, LayerView *view)
{
	char rest;
	return sscanf(text, "%lf,%lf%c", &view->least, &view->most, &rest) == 2 &&
	       view->least < view->most;
}

static const char *take(void *data, int option, const char *value)
{
	Task *task = data;
	switch (option) {
	case OPTION_EXPOSURE:
		return read_exposure(value, &task->view) ? NULL : "a number above 0";
	case OPTION_RANGE: return read_range(value, &task->view) ? NULL : "LEAST,MOST";
	case OPTION_UNLIT: task->view.unlit = true; return NULL;
	default: task->output = value; return NULL;
	}
}

int main(int argc, char **argv)
{
	static const Tool tool = {"cognac-layer", usage, "o:", options, 1, 2, take, run};
	Task task = {.view = {.exposure = 1}};
	return tool_main(&tool, &task, argc, argv);
}
