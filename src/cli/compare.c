/* cognac-compare: how far two pictures differ, in numbers and as a map. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/tool.h"
#include "image/compare.h"
#include "image/layer.h"
#include "image/read.h"
#include "image/write.h"

typedef struct Task {
	const char *layer, *map;
	bool json, halve, crop;
	int x, y, width, height;
} Task;

static const char usage[] =
	"usage: cognac-compare [OPTION]... IMAGE REFERENCE\n"
	"Prints how far IMAGE is from REFERENCE (PNG, OpenEXR, JPEG, TIFF, TGA, PPM ...).\n"
	"\n"
	"      --crop X,Y,W,H   compare only this part\n"
	"      --halve          halve both sizes first\n"
	"      --json           print one JSON object\n"
	"      --layer NAME     compare this layer of OpenEXR files\n"
	"      --map OUT.png    draw the differences in false colours\n"
	"      --help           print this and exit\n"
	"      --version        print the version and exit\n";

/* NULL, reported, when it is not there. */
static Image *read_layer(const char *path, const char *layer, Diag *diag)
{
	ExrImage *exr = exr_read(path, diag);
	Image *image = exr ? layer_extract(exr, layer) : NULL;
	if (exr && !image)
		diag_fail(diag, "%s: no layer %s", path, layer);
	exr_destroy(exr);
	return image;
}

static Image *replace(Image *old, Image *by)
{
	image_destroy(old);
	return by;
}

/* One of the two pictures as the task wants it, or NULL, reported. */
static Image *prepare(const char *path, const Task *task, Diag *diag)
{
	bool colors = !task->layer || strcmp(task->layer, "RGBA") == 0;
	Image *image = colors ? image_read(path, diag) : read_layer(path, task->layer, diag);
	if (image && task->crop) {
		if (task->x + task->width > image->width ||
		    task->y + task->height > image->height) {
			diag_fail(diag, "%s: the part lies outside the %d x %d pixels", path,
				  image->width, image->height);
			image_destroy(image);
			return NULL;
		}
		image = replace(image,
				image_crop(image, task->x, task->y, task->width, task->height));
	}
	if (image && task->halve && image->width > 1 && image->height > 1)
		image = replace(image, image_halve(image));
	return image;
}

static void print_difference(const ImageDifference *d, bool json)
{
	const struct { const char *name; double value; } rows[] = {
		{"MSE", d->mse}, {"RMSE", d->rmse}, {"MRSE", d->mrse}, {"SMAPE", d->smape},
		{"PSNR", d->psnr}, {"SSIM", d->ssim}, {"DSSIM", d->dssim},
	};
	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
		if (!json)
			printf("%s %.9g\n", rows[i].name, rows[i].value);
		else if (isfinite(rows[i].value))
			printf("%s\"%s\": %.9g", i ? ", " : "{", rows[i].name, rows[i].value);
		else
			printf("%s\"%s\": null", i ? ", " : "{",
			       rows[i].name); /* JSON knows no infinity */
	}
	if (json)
		puts("}");
}

static bool write_map(const Task *task, const Image *image, const Image *reference, Diag *diag)
{
	Image *map = image_difference_map(image, reference, 1);
	ImageEncoding encoding = {.format = IMAGE_PNG, .bits = 8, .gamma = 0};
	bool good = image_write(task->map, &encoding, map, diag);
	image_destroy(map);
	return good;
}

static bool run(void *data, char **operands, int count, Diag *diag)
{
	const Task *task = data;
	(void)count;
	Image *image = prepare(operands[0], task, diag);
	Image *reference = image ? prepare(operands[1], task, diag) : NULL;
	ImageDifference difference;
	bool good = reference && image_compare(image, reference, &difference, diag);
	if (good)
		print_difference(&difference, task->json);
	if (good && task->map)
		good = write_map(task, image, reference, diag);
	image_destroy(image);
	image_destroy(reference);
	return good && fflush(stdout) == 0;
}

static bool read_crop(const char *text, Task *task)
{
	char rest;
	task->crop = sscanf(text, "%d,%d,%d,%d%c", &task->x, &task->y, &task->width, &task->height,
			    &rest) == 4;
	return task->crop && task->x >= 0 && task->y >= 0 && task->width > 0 && task->height > 0;
}

enum { OPTION_CROP = 1, OPTION_HALVE, OPTION_JSON, OPTION_LAYER, OPTION_MAP };

static const struct option options[] = {
	{"crop", required_argument, NULL, OPTION_CROP},
	{"halve", no_argument, NULL, OPTION_HALVE},
	{"json", no_argument, NULL, OPTION_JSON},
	{"layer", required_argument, NULL, OPTION_LAYER},
	{"map", required_argument, NULL, OPTION_MAP},
	TOOL_OPTIONS,
};

static const char *take(void *data, int option, const char *value)
{
	Task *task = data;
	switch (option) {
	case OPTION_CROP: return read_crop(value, task) ? NULL : "X,Y,W,H";
	case OPTION_HALVE: task->halve = true; return NULL;
	case OPTION_JSON: task->json = true; return NULL;
	case OPTION_LAYER: task->layer = value; return NULL;
	default: task->map = value; return NULL;
	}
}

int main(int argc, char **argv)
{
	static const Tool tool = {"cognac-compare", usage, "", options, 2, 2, take, run};
	Task task = {0};
	return tool_main(&tool, &task, argc, argv);
}
