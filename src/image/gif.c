/* GIF through giflib: the first picture of the file, with its palette, indices and transparent
 * colour. */
#include <gif_lib.h>
#include <string.h>

#include "image/decode.h"

static int read_bytes(GifFileType *gif, GifByteType *out, int count)
{
	ImageBytes *bytes = gif->UserData;
	size_t left = bytes->size - bytes->at, take = (size_t)count < left ? (size_t)count : left;
	memcpy(out, bytes->data + bytes->at, take);
	bytes->at += take;
	return (int)take;
}

static Image *convert(const GifFileType *gif, const char *path, Diag *diag)
{
	const SavedImage *saved = &gif->SavedImages[0];
	const ColorMapObject *map = saved->ImageDesc.ColorMap ? saved->ImageDesc.ColorMap
							      : gif->SColorMap;
	GraphicsControlBlock control = {.TransparentColor = NO_TRANSPARENT_COLOR};
	DGifSavedExtensionToGCB((GifFileType *)gif, 0, &control);
	bool alpha = control.TransparentColor != NO_TRANSPARENT_COLOR;
	if (!map || map->ColorCount <= 0) {
		diag_fail(diag, "%s: broken GIF: no palette", path);
		return NULL;
	}
	Image *image = image_create(saved->ImageDesc.Width, saved->ImageDesc.Height,
				    IMAGE_RGB + alpha, path, diag);
	if (!image || !image_set_palette(image, map->ColorCount)) {
		image_destroy(image);
		return NULL;
	}
	for (int i = 0; i < map->ColorCount; i++) {
		image->palette[4 * i] = map->Colors[i].Red / 255.0f;
		image->palette[4 * i + 1] = map->Colors[i].Green / 255.0f;
		image->palette[4 * i + 2] = map->Colors[i].Blue / 255.0f;
		image->palette[4 * i + 3] = i == control.TransparentColor ? 0 : 1;
	}
	memcpy(image->indices, saved->RasterBits, (size_t)image->width * image->height);
	image_expand_palette(image);
	return image;
}

Image *image_decode_gif(ImageBytes *bytes, Diag *diag)
{
	int error = 0;
	GifFileType *gif = DGifOpen(bytes, read_bytes, &error);
	Image *image = NULL;
	if (gif && DGifSlurp(gif) == GIF_OK && gif->ImageCount > 0 &&
	    gif->SavedImages[0].RasterBits)
		image = convert(gif, bytes->path, diag);
	else
		diag_fail(diag, "%s: broken GIF", bytes->path);
	if (gif)
		DGifCloseFile(gif, &error);
	return image;
}
