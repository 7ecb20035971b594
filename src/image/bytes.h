/* Private to this room: a file in memory, taken byte by byte; whatever lies past its end is 0. */
#ifndef IMAGE_BYTES_H
#define IMAGE_BYTES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/diag.h"

typedef struct ImageBytes {
	const char *path; /* for messages */
	const uint8_t *data;
	size_t size, at;  /* at: the next byte */
} ImageBytes;

/* The whole file, to be released with free; NULL, reported, when it cannot be read. */
uint8_t *image_bytes_load(const char *path, size_t *size, Diag *diag);

/* Past the end: 0. */
uint8_t image_bytes_u8(ImageBytes *bytes);
uint16_t image_bytes_u16le(ImageBytes *bytes);
uint32_t image_bytes_u32le(ImageBytes *bytes);
bool image_bytes_has(const ImageBytes *bytes, size_t count);

#endif
