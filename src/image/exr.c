/* OpenEXR through the C library OpenEXRCore; our own streams, so that "-" and renaming work as for
 * the other formats. */
#include "image/exr.h"

#include <limits.h>
#include <openexr.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/arena.h"
#include "base/output_file.h"
#include "image/decode.h"

#define MAXIMUM_CHANNELS 256
#define MAXIMUM_VALUES (1L << 30)

static void keep_silent(exr_const_context_t context, exr_result_t code, const char *message)
{
	(void)context;
	(void)code;
	(void)message;
}

/* --- writing --- */

static int64_t stream_write(exr_const_context_t context, void *user, const void *data,
			    uint64_t size, uint64_t offset, exr_stream_error_func_ptr_t error)
{
	OutputFile *file = user;
	ssize_t done = pwrite(fileno(file->stream), data, size, (off_t)offset);
	if (done < 0 || (uint64_t)done != size)
		error(context, EXR_ERR_WRITE_IO, "write failed");
	return done;
}

static exr_result_t write_header(exr_context_t context, const ExrImage *image)
{
	int part = 0;
	exr_result_t status = exr_add_part(context, "image", EXR_STORAGE_SCANLINE, &part);
	if (status == EXR_ERR_SUCCESS)
		status = exr_initialize_required_attr_simple(context, part, image->width,
							     image->height, EXR_COMPRESSION_ZIP);
	for (int i = 0; i < image->channel_count && status == EXR_ERR_SUCCESS; i++)
		status = exr_add_channel(context, part, image->channels[i].name,
		                         image->channels[i].half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT,
		                         EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1);
	for (int i = 0; i < image->attribute_count && status == EXR_ERR_SUCCESS; i++)
		status = exr_attr_set_string(context, part, image->attributes[i].name,
					     image->attributes[i].text);
	return status == EXR_ERR_SUCCESS ? exr_write_header(context) : status;
}

static void point_encoder(exr_encode_pipeline_t *encoder, const ExrImage *image, int y)
{
	for (int i = 0; i < encoder->channel_count; i++) {
		exr_coding_channel_info_t *to = &encoder->channels[i];
		const ExrChannel *from = exr_find(image, to->channel_name);
		to->user_bytes_per_element = sizeof(float);
		to->user_data_type = EXR_PIXEL_FLOAT;
		to->user_pixel_stride = from->stride * (int)sizeof(float);
		to->user_line_stride = to->user_pixel_stride * image->width;
		to->encode_from_ptr = (const uint8_t *)(from->data +
							(size_t)y * image->width * from->stride);
	}
}

static exr_result_t write_chunk(exr_context_t context, const ExrImage *image,
				exr_encode_pipeline_t *encoder, int y)
{
	exr_chunk_info_t chunk;
	exr_result_t status = exr_write_scanline_chunk_info(context, 0, y, &chunk);
	if (status != EXR_ERR_SUCCESS)
		return status;
	status = y == 0 ? exr_encoding_initialize(context, 0, &chunk, encoder)
	                : exr_encoding_update(context, 0, &chunk, encoder);
	if (status != EXR_ERR_SUCCESS)
		return status;
	point_encoder(encoder, image, y);
	if (y == 0)
		status = exr_encoding_choose_default_routines(context, 0, encoder);
	return status == EXR_ERR_SUCCESS ? exr_encoding_run(context, 0, encoder) : status;
}

static exr_result_t write_chunks(exr_context_t context, const ExrImage *image)
{
	exr_encode_pipeline_t encoder = EXR_ENCODE_PIPELINE_INITIALIZER;
	int32_t lines = 1;
	exr_result_t status = exr_get_scanlines_per_chunk(context, 0, &lines);
	for (int y = 0; y < image->height && status == EXR_ERR_SUCCESS; y += lines)
		status = write_chunk(context, image, &encoder, y);
	exr_encoding_destroy(context, &encoder);
	return status;
}

bool exr_write(const char *path, const ExrImage *image, Diag *diag)
{
	OutputFile file;
	if (!output_file_open(&file, path, diag))
		return false;
	exr_context_initializer_t with = EXR_DEFAULT_CONTEXT_INITIALIZER;
	with.error_handler_fn = keep_silent;
	with.user_data = &file;
	with.write_fn = stream_write;
	exr_context_t context = NULL;
	exr_result_t status = exr_start_write(&context, path, EXR_WRITE_FILE_DIRECTLY, &with);
	if (status == EXR_ERR_SUCCESS)
		status = write_header(context, image);
	if (status == EXR_ERR_SUCCESS)
		status = write_chunks(context, image);
	exr_finish(&context);
	if (status == EXR_ERR_SUCCESS)
		return output_file_commit(&file, diag);
	diag_fail(diag, "%s: cannot be written: %s", path, exr_get_default_error_message(status));
	output_file_abandon(&file);
	return false;
}

/* --- reading --- */

static int64_t bytes_size(exr_const_context_t context, void *user)
{
	(void)context;
	return (int64_t)((ImageBytes *)user)->size;
}

static int64_t bytes_read(exr_const_context_t context, void *user, void *out, uint64_t size,
			  uint64_t offset, exr_stream_error_func_ptr_t error)
{
	const ImageBytes *bytes = user;
	(void)context;
	(void)error;
	if (offset >= bytes->size)
		return 0;
	uint64_t left = bytes->size - offset, take = size < left ? size : left;
	memcpy(out, bytes->data + offset, take);
	return (int64_t)take;
}

void exr_destroy(ExrImage *image)
{
	if (!image)
		return;
	for (int i = 0; i < image->channel_count; i++) {
		free((char *)image->channels[i].name);
		free(image->channels[i].data);
	}
	for (int i = 0; i < image->attribute_count; i++) {
		free((char *)image->attributes[i].name);
		free((char *)image->attributes[i].text);
	}
	free(image->channels);
	free((ExrAttribute *)image->attributes);
	free(image);
}

const ExrChannel *exr_find(const ExrImage *image, const char *name)
{
	for (int i = 0; i < image->channel_count; i++)
		if (strcmp(image->channels[i].name, name) == 0)
			return &image->channels[i];
	return NULL;
}

static char *copy_text(const char *text)
{
	char *copy = memory_alloc(strlen(text) + 1);
	return strcpy(copy, text);
}

/* An empty picture with all channels of the file, black; NULL for a layout beyond us. */
static ExrImage *image_for(exr_const_context_t context, const exr_attr_box2i_t *window)
{
	const exr_attr_chlist_t *list = NULL;
	int64_t width = (int64_t)window->max.x - window->min.x + 1,
		height = (int64_t)window->max.y - window->min.y + 1;
	if (exr_get_channels(context, 0, &list) != EXR_ERR_SUCCESS || list->num_channels < 1 ||
	    list->num_channels > MAXIMUM_CHANNELS || width < 1 || height < 1 || width > INT_MAX ||
	    height > INT_MAX || width * height > MAXIMUM_VALUES / list->num_channels)
		return NULL;
	ExrImage *image = calloc(1, sizeof *image);
	image->width = (int)width;
	image->height = (int)height;
	image->channels = calloc((size_t)list->num_channels, sizeof *image->channels);
	for (int i = 0; i < list->num_channels; i++) {
		ExrChannel *channel = &image->channels[image->channel_count++];
		channel->name = copy_text(list->entries[i].name.str);
		channel->data = calloc((size_t)(width * height), sizeof(float));
		channel->stride = 1;
		channel->half = list->entries[i].pixel_type == EXR_PIXEL_HALF;
		if (list->entries[i].x_sampling != 1 || list->entries[i].y_sampling != 1 ||
		    !channel->data) {
			exr_destroy(image);
			return NULL;
		}
	}
	return image;
}

static void read_attributes(exr_const_context_t context, ExrImage *image)
{
	int32_t count = 0;
	exr_get_attribute_count(context, 0, &count);
	ExrAttribute *attributes = calloc((size_t)count + 1, sizeof *attributes);
	for (int32_t i = 0; i < count; i++) {
		const exr_attribute_t *attribute = NULL;
		exr_get_attribute_by_index(context, 0, EXR_ATTR_LIST_FILE_ORDER, i, &attribute);
		if (attribute && attribute->type == EXR_ATTR_STRING && attribute->string->str)
			attributes[image->attribute_count++] = (ExrAttribute){
				copy_text(attribute->name), copy_text(attribute->string->str)};
	}
	image->attributes = attributes;
}

typedef struct Chunks {
	exr_const_context_t context;
	ExrImage *image;
	exr_decode_pipeline_t decoder;
	bool started;
} Chunks;

/* Decodes one chunk whose first pixel is (x, y) of the picture. */
static exr_result_t read_chunk(Chunks *c, const exr_chunk_info_t *chunk, int x, int y)
{
	exr_result_t status = c->started
				      ? exr_decoding_update(c->context, 0, chunk, &c->decoder)
				      : exr_decoding_initialize(c->context, 0, chunk, &c->decoder);
	if (status != EXR_ERR_SUCCESS)
		return status;
	for (int i = 0; i < c->decoder.channel_count; i++) {
		exr_coding_channel_info_t *to = &c->decoder.channels[i];
		to->user_bytes_per_element = sizeof(float);
		to->user_data_type = EXR_PIXEL_FLOAT;
		to->user_pixel_stride = sizeof(float);
		to->user_line_stride = c->image->width * (int)sizeof(float);
		to->decode_to_ptr = (uint8_t *)(c->image->channels[i].data +
						(size_t)y * c->image->width + x);
	}
	if (!c->started)
		status = exr_decoding_choose_default_routines(c->context, 0, &c->decoder);
	c->started = true;
	return status == EXR_ERR_SUCCESS ? exr_decoding_run(c->context, 0, &c->decoder) : status;
}

static exr_result_t read_scanlines(Chunks *c, const exr_attr_box2i_t *window)
{
	int32_t lines = 1;
	exr_result_t status = exr_get_scanlines_per_chunk(c->context, 0, &lines);
	for (int y = 0; y < c->image->height && status == EXR_ERR_SUCCESS; y += lines) {
		exr_chunk_info_t chunk;
		status = exr_read_scanline_chunk_info(c->context, 0, window->min.y + y, &chunk);
		if (status == EXR_ERR_SUCCESS)
			status = read_chunk(c, &chunk, 0, y);
	}
	return status;
}

static exr_result_t read_tiles(Chunks *c)
{
	uint32_t width = 1, height = 1;
	exr_tile_level_mode_t levels;
	exr_tile_round_mode_t rounding;
	exr_result_t status = exr_get_tile_descriptor(c->context, 0, &width, &height, &levels,
						      &rounding);
	for (uint32_t y = 0; y < (uint32_t)c->image->height && status == EXR_ERR_SUCCESS;
	     y += height)
		for (uint32_t x = 0; x < (uint32_t)c->image->width && status == EXR_ERR_SUCCESS;
		     x += width) {
			exr_chunk_info_t chunk;
			status = exr_read_tile_chunk_info(c->context, 0, (int)(x / width),
							  (int)(y / height), 0, 0, &chunk);
			if (status == EXR_ERR_SUCCESS)
				status = read_chunk(c, &chunk, (int)x, (int)y);
		}
	return status;
}

/* NULL when the picture is broken or of a kind we do not read. */
static ExrImage *read_part(exr_const_context_t context)
{
	exr_attr_box2i_t window;
	exr_storage_t storage;
	if (exr_get_data_window(context, 0, &window) != EXR_ERR_SUCCESS ||
	    exr_get_storage(context, 0, &storage) != EXR_ERR_SUCCESS)
		return NULL;
	bool tiled = storage == EXR_STORAGE_TILED;
	ExrImage *image = tiled || storage == EXR_STORAGE_SCANLINE ? image_for(context, &window)
								   : NULL;
	if (!image)
		return NULL;
	read_attributes(context, image);
	Chunks chunks = {
		.context = context, .image = image, .decoder = EXR_DECODE_PIPELINE_INITIALIZER};
	exr_result_t status = tiled ? read_tiles(&chunks) : read_scanlines(&chunks, &window);
	exr_decoding_destroy(context, &chunks.decoder);
	if (status == EXR_ERR_SUCCESS)
		return image;
	exr_destroy(image);
	return NULL;
}

static ExrImage *read_bytes(ImageBytes *bytes, Diag *diag)
{
	exr_context_initializer_t with = EXR_DEFAULT_CONTEXT_INITIALIZER;
	with.error_handler_fn = keep_silent;
	with.user_data = bytes;
	with.read_fn = bytes_read;
	with.size_fn = bytes_size;
	exr_context_t context = NULL;
	ExrImage *image = NULL;
	if (exr_start_read(&context, bytes->path, &with) == EXR_ERR_SUCCESS)
		image = read_part(context);
	exr_finish(&context);
	if (!image)
		diag_fail(diag, "%s: broken OpenEXR file, or of a kind that cannot be read",
			  bytes->path);
	return image;
}

ExrImage *exr_read(const char *path, Diag *diag)
{
	ImageBytes bytes = {.path = path};
	uint8_t *data = image_bytes_load(path, &bytes.size, diag);
	if (!data)
		return NULL;
	bytes.data = data;
	ExrImage *image = read_bytes(&bytes, diag);
	free(data);
	return image;
}

/* --- as a picture --- */

static void copy_channel(Image *image, int channel, const ExrChannel *from)
{
	size_t count = (size_t)image->width * image->height;
	for (size_t i = 0; i < count; i++)
		image->pixels[i * image->channels + channel] = from->data[i];
}

/* OpenEXR's colours are premultiplied. */
static void divide_by_alpha(Image *image)
{
	size_t count = (size_t)image->width * image->height;
	int last = image->channels - 1;
	for (size_t i = 0; i < count; i++) {
		float *pixel = image->pixels + i * image->channels;
		for (int c = 0; c < last && pixel[last] > 0; c++)
			pixel[c] /= pixel[last];
	}
}

Image *image_decode_exr(ImageBytes *bytes, Diag *diag)
{
	static const char *const color_names[] = {"R", "G", "B", "A"}, *const gray_names[] = {"Y",
											      "A"};
	ExrImage *exr = read_bytes(bytes, diag);
	if (!exr)
		return NULL;
	bool color = exr_find(exr, "R") && exr_find(exr, "G") && exr_find(exr, "B");
	bool alpha = exr_find(exr, "A") != NULL;
	const char *const *names = color ? color_names : gray_names;
	Image *image = NULL;
	if (!color && !exr_find(exr, "Y"))
		diag_fail(diag, "%s: neither R, G and B nor Y among the channels", bytes->path);
	else
		image = image_create(exr->width, exr->height, (color ? 3 : 1) + alpha, bytes->path,
				     diag);
	for (int c = 0; image && c < image->channels; c++)
		copy_channel(image, c, exr_find(exr, names[c]));
	if (image) {
		image->linear = true;
		image->bits = 32;
		if (alpha)
			divide_by_alpha(image);
	}
	exr_destroy(exr);
	return image;
}
