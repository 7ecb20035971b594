/* Every format there and back, layers, broken files, transfer functions, and the measures of
 * difference. */
#include "image/compare.h"

#include <stdlib.h>
#include <unistd.h>

#include "base/output_file.h"
#include "check.h"
#include "image/exr.h"
#include "image/read.h"
#include "image/write.h"

static char folder[] = "test_image.XXXXXX";
static char path[200];

static const char *file_name(const char *name)
{
	snprintf(path, sizeof path, "%s/%s", folder, name);
	return path;
}

/* Smooth, with runs of equal pixels and some alpha. */
static Image *make_picture(int width, int height)
{
	Image *image = calloc(1, sizeof *image);
	*image = (Image){.width = width, .height = height, .channels = 4, .linear = true};
	image->pixels = calloc((size_t)width * height * 4, sizeof(float));
	for (int y = 0; y < height; y++)
		for (int x = 0; x < width; x++) {
			float *p = image->pixels + 4 * (y * width + x);
			p[0] = (float)(x / 4) / (float)width;
			p[1] = (float)y / (float)height;
			p[2] = x > width / 2 ? 1 : 0.25f;
			p[3] = y > height / 2 ? 1 : 0.5f;
		}
	return image;
}

typedef struct Trip {
	const char *name;
	ImageEncoding encoding;
	int channels;
	double tolerance;
} Trip;

static const Trip trips[] = {
	{"a.png", {.format = IMAGE_PNG, .bits = 8, .gamma = -1}, 3, 0.005},
	{"b.png", {.format = IMAGE_PNG, .bits = 16, .alpha = true, .gamma = -1}, 4, 2e-5},
	{"c.png", {.format = IMAGE_PNG, .bits = 8, .gamma = 1.8}, 3, 0.006},
	{"d.png", {.format = IMAGE_PNG, .bits = 5, .gamma = 1}, 3, 0.017},
	{"e.tga", {.format = IMAGE_TGA, .bits = 8, .gamma = 0}, 3, 0.002},
	{"f.tga", {.format = IMAGE_TGA_RLE, .bits = 8, .alpha = true}, 4, 0.002},
	{"g.ppm", {.format = IMAGE_PPM, .bits = 8}, 3, 0.002},
	{"h.ppm", {.format = IMAGE_PPM, .bits = 16}, 3, 1e-5},
	{"i.bmp", {.format = IMAGE_BMP, .bits = 8}, 3, 0.002},
	{"j.bmp", {.format = IMAGE_BMP, .bits = 8, .alpha = true}, 4, 0.002},
	{"k.jpg", {.format = IMAGE_JPEG, .bits = 8, .quality = 100}, 3, 0.03},
	{"l.exr", {.format = IMAGE_EXR, .alpha = true}, 4, 0.001},
	{"m.png", {.format = IMAGE_PNG, .bits = 8, .dither = true, .gamma = 1}, 3, 0.005},
};

static void check_trip(const Trip *trip, const Image *picture, Diag *diag)
{
	CHECK(image_write(file_name(trip->name), &trip->encoding, picture, diag));
	Image *back = image_read(file_name(trip->name), diag);
	CHECK(back != NULL);
	if (!back)
		return;
	CHECK(back->width == picture->width && back->height == picture->height);
	CHECK(back->channels == trip->channels);
	image_linearize(back, 1);
	double worst = 0;
	for (int i = 0; i < back->width * back->height; i++)
		for (int c = 0; c < back->channels; c++)
			worst = fmax(worst, fabs(back->pixels[i * back->channels + c] -
						 picture->pixels[4 * i + c]));
	if (!(worst <= trip->tolerance))
		printf("%s: off by %g\n", trip->name, worst);
	CHECK(worst <= trip->tolerance);
	image_destroy(back);
}

/* Cut short and with bytes changed: an error or some picture, never a crash. */
static void check_broken(const char *name)
{
	Diag *silent = diag_create(NULL);
	FILE *file = fopen(file_name(name), "rb");
	static unsigned char data[1 << 20];
	size_t size = fread(data, 1, sizeof data, file);
	fclose(file);
	for (size_t i = 0; i < 60; i++) {
		size_t keep = i < 30 ? size * i / 30 : size;
		FILE *out = fopen(file_name("broken"), "wb");
		fwrite(data, 1, keep, out);
		fseek(out, (long)((i * 7919) % (i % 2 ? 60 : size)), SEEK_SET);
		if (i >= 30)
			putc((int)(i * 37 & 255), out);
		fclose(out);
		Image *image = image_read(file_name("broken"), silent);
		if (i < 15) /* half of the file is missing */
			CHECK(image == NULL || strstr(name, ".jpg") != NULL);
		image_destroy(image);
	}
	diag_destroy(silent);
}

static void check_exr_layers(Diag *diag)
{
	float color[3 * 5 * 4], depth[3 * 5];
	for (int i = 0; i < 60; i++)
		color[i] = (float)i;
	for (int i = 0; i < 15; i++)
		depth[i] = 1e6f + (float)i;
	ExrChannel channels[] = {{"caustic.R", color, 4, true},
				 {"caustic.G", color + 1, 4, true},
				 {"Z", depth, 1, false}};
	ExrAttribute attributes[] = {{"scene", "glass.pov"}, {"seed", "42"}};
	ExrImage image = {3, 5, 3, channels, 2, attributes};
	CHECK(exr_write(file_name("layers.exr"), &image, diag));
	ExrImage *back = exr_read(file_name("layers.exr"), diag);
	CHECK(back != NULL);
	if (!back)
		return;
	CHECK(back->width == 3 && back->height == 5 && back->channel_count == 3);
	CHECK(exr_find(back, "Z") && exr_find(back, "Z")->data[14] == 1e6f + 14);
	CHECK(exr_find(back, "caustic.G") && exr_find(back, "caustic.G")->data[7] == 29);
	CHECK(!exr_find(back, "caustic.B"));
	int found = 0;
	for (int i = 0; i < back->attribute_count; i++)
		found += strcmp(back->attributes[i].name, "seed") == 0 &&
			 strcmp(back->attributes[i].text, "42") == 0;
	CHECK(found == 1);
	exr_destroy(back);
}

static void write_text(const char *name, const char *data, size_t size)
{
	FILE *file = fopen(file_name(name), "wb");
	fwrite(data, 1, size, file);
	fclose(file);
}

static void check_small_files(Diag *diag)
{
	static const char text[] = "P3 # a comment\n2 1\n255\n255 0 0  0 51 255\n";
	write_text("t.ppm", text, sizeof text - 1);
	Image *image = image_read(file_name("t.ppm"), diag);
	CHECK(image && image->channels == 3 && image->pixels[0] == 1 &&
	      fabsf(image->pixels[4] - 0.2f) < 1e-6f);
	image_destroy(image);
	static const char gif[] =
		"GIF89a\2\0\1\0\x80\0\0\xff\0\0\0\0\xff,\0\0\0\0\2\0\1\0\0\2\2\x44\x0a\0;";
	write_text("t.gif", gif, sizeof gif - 1);
	image = image_read(file_name("t.gif"), diag);
	CHECK(image && image->width == 2 && image->palette_count == 2 && image->indices[0] == 0);
	CHECK(image && image->pixels[0] == 1 && image->pixels[5] == 1);
	image_destroy(image);
	Diag *silent = diag_create(NULL);
	CHECK(!image_read(file_name("missing.png"), silent));
	write_text("empty", "", 0);
	CHECK(!image_read(file_name("empty"), silent));
	write_text("junk", "this is no picture at all, only some text", 41);
	CHECK(!image_read(file_name("junk"), silent));
	CHECK(diag_errors(silent) == 3);
	diag_destroy(silent);
}

static void check_transfer(void)
{
	CHECK_NEAR(image_transfer_encode(0.03125, -1) * 255, 49.4564, 1e-3);
	CHECK_NEAR(image_transfer_encode(0.25, 2), 0.5, 1e-12);
	for (double v = 0; v <= 1; v += 0.01)
		CHECK_NEAR(image_transfer_decode(image_transfer_encode(v, -1), -1), v, 1e-6);
}

static void check_compare(Diag *diag)
{
	Image *a = make_picture(32, 24), *b = make_picture(32, 24);
	ImageDifference d;
	CHECK(image_compare(a, b, &d, diag));
	CHECK(d.mse == 0 && isinf(d.psnr) && fabs(d.ssim - 1) < 1e-9);
	for (int i = 0; i < 32 * 24 * 4; i++)
		b->pixels[i] = a->pixels[i] = 0.5f;
	for (int i = 0; i < 32 * 24 * 4; i++)
		a->pixels[i] = 0.6f;
	CHECK(image_compare(a, b, &d, diag));
	CHECK_NEAR(d.mse, 0.01, 1e-6);
	CHECK_NEAR(d.rmse, 0.1, 1e-6);
	CHECK_NEAR(d.psnr, 20, 1e-4);
	CHECK_NEAR(d.mrse, 0.01 / 0.26, 1e-6);
	CHECK_NEAR(d.smape, 0.2 / 1.1, 1e-6);
	CHECK_NEAR(d.ssim, (2 * 0.3 + 1e-4) / (0.61 + 1e-4),
		   1e-3); /* flat images: the luminance term alone */
	Image *half = image_halve(a), *part = image_crop(a, 3, 4, 5, 6),
	      *map = image_difference_map(a, b, 0.1);
	CHECK(half->width == 16 && half->height == 12 && fabsf(half->pixels[0] - 0.6f) < 1e-6f);
	CHECK(part->width == 5 && part->height == 6);
	CHECK_NEAR(map->pixels[2], 1, 1e-5);
	Diag *silent = diag_create(NULL);
	CHECK(!image_compare(half, b, &d, silent) && diag_errors(silent) == 1);
	diag_destroy(silent);
	image_destroy(half);
	image_destroy(part);
	image_destroy(map);
	image_destroy(a);
	image_destroy(b);
}

/* Whole or not there. */
static void check_output_file(Diag *diag)
{
	OutputFile file;
	Diag *silent = diag_create(NULL);
	CHECK(!output_file_open(&file, file_name("no/such/folder.png"), silent));
	CHECK(output_file_open(&file, file_name("whole"), diag));
	fputs("text", file.stream);
	CHECK(access(file_name("whole"), F_OK) != 0);
	output_file_abandon(&file);
	CHECK(access(file_name("whole"), F_OK) != 0);
	CHECK(output_file_open(&file, file_name("whole"), diag) && output_file_commit(&file, diag));
	CHECK(access(file_name("whole"), F_OK) == 0);
	diag_destroy(silent);
}

int main(void)
{
	Diag *diag = diag_create(stderr);
	if (!mkdtemp(folder))
		return 1;
	Image *picture = make_picture(37, 29);
	for (size_t i = 0; i < sizeof trips / sizeof *trips; i++) {
		check_trip(&trips[i], picture, diag);
		check_broken(trips[i].name);
	}
	image_destroy(picture);
	check_exr_layers(diag);
	check_small_files(diag);
	check_transfer();
	check_compare(diag);
	check_output_file(diag);
	diag_destroy(diag);
	char command[100];
	snprintf(command, sizeof command, "rm -rf %s", folder);
	CHECK(system(command) == 0);
	return CHECK_RESULT();
}
