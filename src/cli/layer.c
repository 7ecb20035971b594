/* cognac-layer: what layers an OpenEXR picture has, and one of them as a PNG to look at. */
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "config.h"
#include "image/layer.h"
#include "image/write.h"

typedef struct Task {
	const char *picture, *layer, *output;
	LayerView view;
} Task;

static void print_usage(FILE *out)
{
	fputs("usage: cognac-layer [OPTION]... PICTURE.exr [LAYER]\n"
	      "Draws a layer of an OpenEXR picture as PNG; without LAYER names the layers and their values' bounds.\n"
	      "\n"
	      "  -o, --output=FILE        the PNG; PICTURE.LAYER.png without it\n"
	      "      --exposure=FACTOR    multiply light by this first\n"
	      "      --range=LEAST,MOST   of the colour scale of layers of numbers\n"
	      "      --unlit              do not shade layers of photons by the caustic\n"
	      "      --help               print this and exit\n"
	      "      --version            print the version and exit\n",
	      out);
}

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

static bool run(const Task *task, Diag *diag)
{
	ExrImage *exr = exr_read(task->picture, diag);
	bool good = exr && (task->layer ? write_layer(task, exr, diag) : list_layers(exr));
	exr_destroy(exr);
	return good;
}

enum { OPTION_EXPOSURE = 1, OPTION_RANGE, OPTION_UNLIT, OPTION_HELP, OPTION_VERSION };

static bool read_exposure(const char *text, Task *task)
{
	char rest;
	if (sscanf(text, "%lf%c", &task->view.exposure, &rest) == 1 && task->view.exposure > 0)
		return true;
	fprintf(stderr, "cognac-layer: --exposure wants a number above 0, not %s\n", text);
	return false;
}

static bool read_range(const char *text, Task *task)
{
	char rest;
	if (sscanf(text, "%lf,%lf%c", &task->view.least, &task->view.most, &rest) == 2 &&
	    task->view.least < task->view.most)
		return true;
	fprintf(stderr, "cognac-layer: --range wants LEAST,MOST, not %s\n", text);
	return false;
}

/* 0 go on, 1 done well, -1 a mistake. */
static int read_options(int argc, char **argv, Task *task)
{
	static const struct option options[] = {
		{"output", required_argument, NULL, 'o'},
		{"exposure", required_argument, NULL, OPTION_EXPOSURE},
		{"range", required_argument, NULL, OPTION_RANGE},
		{"unlit", no_argument, NULL, OPTION_UNLIT},
		{"help", no_argument, NULL, OPTION_HELP},
		{"version", no_argument, NULL, OPTION_VERSION},
		{NULL, 0, NULL, 0},
	};
	int option;
	bool good = true;
	while (good && (option = getopt_long(argc, argv, "o:", options, NULL)) != -1) {
		switch (option) {
		case 'o': task->output = optarg; break;
		case OPTION_EXPOSURE: good = read_exposure(optarg, task); break;
		case OPTION_RANGE: good = read_range(optarg, task); break;
		case OPTION_UNLIT: task->view.unlit = true; break;
		case OPTION_HELP: print_usage(stdout); return 1;
		case OPTION_VERSION: puts("cognac-layer " PACKAGE_VERSION); return 1;
		default: good = false;
		}
	}
	if (good && argc - optind != 1 && argc - optind != 2)
		print_usage(stderr);
	else if (good)
		task->picture = argv[optind], task->layer = argv[optind + 1]; /* or NULL */
	return task->picture ? 0 : -1;
}

int main(int argc, char **argv)
{
	Task task = {.view = {.exposure = 1}};
	int state = read_options(argc, argv, &task);
	if (state != 0)
		return state < 0;
	Diag *diag = diag_create(stderr);
	bool good = run(&task, diag);
	diag_destroy(diag);
	return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
