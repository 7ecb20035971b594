/*
 * Private to this room: one decoder a format, each from the whole file in memory. A decoder returns
 * NULL and reports for a broken file; sizes come from the file and are never trusted before
 * image_create has seen them.
 */
#ifndef IMAGE_DECODE_H
#define IMAGE_DECODE_H

#include "image/bytes.h"
#include "image/image.h"

Image *image_decode_png(ImageBytes *bytes, Diag *diag);
Image *image_decode_jpeg(ImageBytes *bytes, Diag *diag);
Image *image_decode_tiff(ImageBytes *bytes, Diag *diag);
Image *image_decode_gif(ImageBytes *bytes, Diag *diag);
Image *image_decode_tga(ImageBytes *bytes, Diag *diag);
Image *image_decode_pnm(ImageBytes *bytes, Diag *diag);
Image *image_decode_bmp(ImageBytes *bytes, Diag *diag);
Image *image_decode_exr(ImageBytes *bytes, Diag *diag);
Image *image_decode_hdr(ImageBytes *bytes, Diag *diag);

#endif
