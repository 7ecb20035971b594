/*
 * cognac-merge: puts the parts of one picture together that several runs rendered (+SR, +ER, +SC,
 * +EC). The parts are PNG or OpenEXR files; each names the pixels it holds. The result has the bits
 * of a picture that one run rendered.
 */
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "cli/tool.h"
#include "image/exr.h"
#include "image/read.h"
#include "image/write.h"

/* One file. An OpenEXR file keeps all its layers; any other is an Image. */
typedef struct Part {
	const char *path;
	ExrImage *exr;
	Image *image;
	int width, height;
	ImageRegion region;
} Part;

/* The picture in the making is the first part; the others' pixels go there. */
typedef struct Merge {
	Part whole;
	bool *covered; /* a pixel each */
	Diag *diag;
} Merge;

static void part_release(Part *part)
{
	exr_destroy(part->exr);
	image_destroy(part->image);
}

static bool is_exr(const char *path)
{
	static const char magic[4] = "\x76\x2f\x31\x01";
	char bytes[4] = "";
	FILE *file = fopen(path, "rb");
	bool found = file && fread(bytes, sizeof bytes, 1, file) == 1 &&
		     memcmp(bytes, magic, sizeof magic) == 0;
	if (file)
		fclose(file);
	return found;
}

static const char *exr_attribute(const ExrImage *exr, const char *name)
{
	for (int i = 0; i < exr->attribute_count; i++)
		if (strcmp(exr->attributes[i].name, name) == 0)
			return exr->attributes[i].text;
	return "";
}

static bool region_fits(const Part *part)
{
	const ImageRegion *r = &part->region;
	return image_region_is_part(r) && r->x1 <= part->width && r->y1 <= part->height;
}

/* Fills in all but the path. False on failure, reported. */
static bool part_read(Part *part, Diag *diag)
{
	if (is_exr(part->path)) {
		part->exr = exr_read(part->path, diag);
		if (!part->exr)
			return false;
		part->width = part->exr->width;
		part->height = part->exr->height;
		part->region = image_region_read(exr_attribute(part->exr, "region"));
	} else {
		part->image = image_read(part->path, diag);
		if (!part->image)
			return false;
		part->width = part->image->width;
		part->height = part->image->height;
		part->region = part->image->region;
	}
	if (region_fits(part))
		return true;
	diag_fail(diag, "%s: no part of a picture: it does not say which pixels it holds",
		  part->path);
	return false;
}

static int plane_count(const Part *part)
{
	return part->exr ? part->exr->channel_count : part->image->channels;
}

static float *plane_value(const Part *part, int plane, size_t pixel)
{
	if (part->exr)
		return part->exr->channels[plane].data + pixel * part->exr->channels[plane].stride;
	return part->image->pixels + pixel * part->image->channels + plane;
}

static bool planes_match(const Part *a, const Part *b)
{
	if (a->exr)
		for (int i = 0; i < a->exr->channel_count; i++)
			if (strcmp(a->exr->channels[i].name, b->exr->channels[i].name) != 0)
				return false;
	return a->exr ||
	       (a->image->bits == b->image->bits && fabs(a->image->gamma - b->image->gamma) < 1e-3);
}

static bool parts_match(const Part *a, const Part *b)
{
	return a->width == b->width && a->height == b->height && !a->exr == !b->exr &&
	       plane_count(a) == plane_count(b) && planes_match(a, b);
}

/* Where two parts hold the same pixel they must agree on it, else they are of different pictures.
 */
static bool merge_pixel(Merge *merge, const Part *part, size_t pixel)
{
	for (int plane = 0; plane < plane_count(part); plane++) {
		float *to = plane_value(&merge->whole, plane, pixel);
		const float *from = plane_value(part, plane, pixel);
		if (merge->covered[pixel] && memcmp(to, from, sizeof *to) != 0)
			return false;
		*to = *from;
	}
	return merge->covered[pixel] = true;
}

static bool merge_part(Merge *merge, const Part *part)
{
	const ImageRegion *r = &part->region;
	if (!parts_match(&merge->whole, part)) {
		diag_fail(merge->diag, "%s and %s differ in size, format or layers",
			  merge->whole.path, part->path);
		return false;
	}
	for (int y = r->y0; y < r->y1; y++)
		for (int x = r->x0; x < r->x1; x++)
			if (!merge_pixel(merge, part, (size_t)y * part->width + x)) {
				diag_fail(merge->diag,
					  "%s holds another pixel %d, %d than an earlier part",
					  part->path, x, y);
				return false;
			}
	return true;
}

static bool merge_file(Merge *merge, const char *path)
{
	Part part = {.path = path};
	bool good = part_read(&part, merge->diag) && merge_part(merge, &part);
	part_release(&part);
	return good;
}

static bool is_complete(const Merge *merge)
{
	size_t count = (size_t)merge->whole.width * merge->whole.height;
	for (size_t i = 0; i < count; i++)
		if (!merge->covered[i]) {
			diag_fail(merge->diag, "no part holds the pixel %d, %d",
				  (int)(i % merge->whole.width), (int)(i / merge->whole.width));
			return false;
		}
	return true;
}

/* The header of a whole picture names no region; what the format writes by itself goes as well. */
static bool write_exr(const Merge *merge, const char *path)
{
	ExrImage out = *merge->whole.exr;
	ExrAttribute *kept = memory_alloc(sizeof *kept * ((size_t)out.attribute_count + 1));
	int count = 0;
	for (int i = 0; i < out.attribute_count; i++) {
		const char *name = out.attributes[i].name;
		if (strcmp(name, "region") != 0 && strcmp(name, "name") != 0 &&
		    strcmp(name, "type") != 0)
			kept[count++] = out.attributes[i];
	}
	out.attributes = kept;
	out.attribute_count = count;
	bool good = exr_write(path, &out, merge->diag);
	free(kept);
	return good;
}

/* Pixels as image_write takes them: four channels of linear light. */
static Image four_channels(const Image *image)
{
	size_t count = (size_t)image->width * image->height;
	Image out = {.width = image->width,
		     .height = image->height,
		     .channels = IMAGE_RGBA,
		     .linear = image->linear,
		     .bits = image->bits,
		     .gamma = image->gamma};
	out.pixels = memory_alloc(count * IMAGE_RGBA * sizeof *out.pixels);
	bool gray = image->channels < IMAGE_RGB, alpha = image->channels % 2 == 0;
	for (size_t i = 0; i < count; i++) {
		const float *from = image->pixels + i * image->channels;
		for (int c = 0; c < IMAGE_RGB; c++)
			out.pixels[IMAGE_RGBA * i + c] = from[gray ? 0 : c];
		out.pixels[IMAGE_RGBA * i + IMAGE_RGB] = alpha ? from[image->channels - 1]
								     : 1;
	}
	return out;
}

static bool write_png(const Merge *merge, const char *path)
{
	const Image *image = merge->whole.image;
	ImageEncoding encoding = {
		.format = IMAGE_PNG, .bits = image->bits, .alpha = image->channels % 2 == 0,
		.gray = image->channels < IMAGE_RGB, .gamma = image->gamma,
	};
	Image out = four_channels(image);
	image_linearize(&out, 1);
	bool good = image_write(path, &encoding, &out, merge->diag);
	free(out.pixels);
	return good;
}

static const char usage[] =
	"usage: cognac-merge --output=FILE PART...\n"
	"Puts the parts of one picture (PNG or OpenEXR, rendered with +SR, +ER, +SC, +EC)\n"
	"together.\n"
	"\n"
	"  -o, --output=FILE    the whole picture, in the format of its parts\n"
	"      --help           print this and exit\n"
	"      --version        print the version and exit\n";

typedef struct Task {
	const char *output; /* NULL until the option is met */
} Task;

static bool merge_all(const char *output, int count, char **paths, Diag *diag)
{
	Merge merge = {.whole = {.path = paths[0]}, .diag = diag};
	bool good = part_read(&merge.whole, diag);
	if (good) {
		merge.covered = calloc((size_t)merge.whole.width * merge.whole.height,
				       sizeof *merge.covered);
		good = merge.covered && merge_part(&merge, &merge.whole);
	}
	for (int i = 1; i < count && good; i++)
		good = merge_file(&merge, paths[i]);
	if (good && is_complete(&merge))
		good = merge.whole.exr ? write_exr(&merge, output) : write_png(&merge, output);
	else
		good = false;
	free(merge.covered);
	part_release(&merge.whole);
	return good;
}

static const char *take(void *task, int option, const char *value)
{
	(void)option;
	((Task *)task)->output = value;
	return NULL;
}

static bool run(void *task, char **operands, int count, Diag *diag)
{
	const char *output = ((const Task *)task)->output;
	if (output)
		return merge_all(output, count, operands, diag);
	diag_fail(diag, "no --output=FILE for the whole picture");
	return false;
}

int main(int argc, char **argv)
{
	static const struct option options[] = {
		{"output", required_argument, NULL, 'o'},
		TOOL_OPTIONS,
	};
	static const Tool tool = {"cognac-merge", usage, "o:", options, 1, INT_MAX, take, run};
	Task task = {NULL};
	return tool_main(&tool, &task, argc, argv);
}
