#include "image/bytes.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"

bool image_bytes_has(const ImageBytes *bytes, size_t count)
{
	return bytes->at <= bytes->size && count <= bytes->size - bytes->at;
}

uint8_t image_bytes_u8(ImageBytes *bytes)
{
	return bytes->at < bytes->size ? bytes->data[bytes->at++] : 0;
}

uint16_t image_bytes_u16le(ImageBytes *bytes)
{
	uint16_t low = image_bytes_u8(bytes);
	return (uint16_t)(low | image_bytes_u8(bytes) << 8);
}

uint32_t image_bytes_u32le(ImageBytes *bytes)
{
	uint32_t low = image_bytes_u16le(bytes);
	return low | (uint32_t)image_bytes_u16le(bytes) << 16;
}

/* The whole stream; errno is set when ferror is. */
static uint8_t *read_whole(FILE *file, size_t *size)
{
	size_t used = 0, room = 1 << 16;
	uint8_t *data = memory_alloc(room);
	for (;;) {
		size_t got = fread(data + used, 1, room - used, file);
		used += got;
		if (got == 0)
			break;
		if (used == room)
			data = memory_resize(data, room *= 2);
	}
	*size = used;
	return data;
}

uint8_t *image_bytes_load(const char *path, size_t *size, Diag *diag)
{
	FILE *file = fopen(path, "rb");
	if (!file) {
		diag_fail(diag, "%s: %s", path, strerror(errno));
		return NULL;
	}
	uint8_t *data = read_whole(file, size);
	if (ferror(file)) {
		diag_fail(diag, "%s: %s", path, strerror(errno));
		free(data);
		data = NULL;
	}
	fclose(file);
	return data;
}
