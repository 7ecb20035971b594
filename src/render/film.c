#include "render/film.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/output_file.h"

typedef enum PixelState { PIXEL_EMPTY, PIXEL_STARTED, PIXEL_FINAL } PixelState;

struct Film {
	int width, height;
	unsigned layers;
	uint32_t passes;                 /* that were averaged */
	uint64_t photons;
	float *planes[FILM_LAYER_COUNT]; /* NULL for absent layers */
	unsigned char *state;            /* PixelState of each pixel */
	pthread_mutex_t lock;
};

typedef struct LayerInfo {
	const char *name;
	int channels, offset;
} LayerInfo;

static const LayerInfo layer_info[FILM_LAYER_COUNT] = {
	[FILM_COLOR] = {"RGBA", 4, 0},
	[FILM_DIRECT] = {"direct", 3, 4},
	[FILM_CAUSTIC] = {"caustic", 3, 7},
	[FILM_ALBEDO] = {"albedo", 3, 10},
	[FILM_NORMAL] = {"N", 3, 13},
	[FILM_DEPTH] = {"Z", 1, 16},
	[FILM_PHOTON_COUNT] = {"photons.count", 1, 17},
	[FILM_PHOTON_PARAMETER] = {"photons.parameter", 3, 18},
	[FILM_PHOTON_EDGES] = {"photons.edges", 1, 21},
	[FILM_PHOTON_CONSTRAINT] = {"photons.constraint", 1, 22},
};

static size_t pixel_count(const Film *film)
{
	return (size_t)film->width * (size_t)film->height;
}

static size_t plane_bytes(const Film *film, FilmLayer layer)
{
	return pixel_count(film) * (size_t)layer_info[layer].channels * sizeof(float);
}

double film_bytes(int width, int height, unsigned layers)
{
	double channels = 0;
	for (int i = 0; i < FILM_LAYER_COUNT; i++)
		if ((layers | 1u << FILM_COLOR) >> i & 1)
			channels += layer_info[i].channels;
	return (double)width * height * (1 + channels * sizeof(float));
}

Film *film_create(int width, int height, unsigned layers)
{
	Film *film = memory_alloc(sizeof *film);
	*film = (Film){.width = width, .height = height, .layers = layers | 1u << FILM_COLOR};
	for (int i = 0; i < FILM_LAYER_COUNT; i++) {
		if (!film_has(film, i))
			continue;
		film->planes[i] = memory_alloc(plane_bytes(film, i));
		memset(film->planes[i], 0, plane_bytes(film, i));
	}
	film->state = memory_alloc(pixel_count(film));
	memset(film->state, PIXEL_EMPTY, pixel_count(film));
	pthread_mutex_init(&film->lock, NULL);
	return film;
}

Film *film_create_like(const Film *film)
{
	return film_create(film->width, film->height, film->layers);
}

void film_destroy(Film *film)
{
	if (!film)
		return;
	for (int i = 0; i < FILM_LAYER_COUNT; i++)
		free(film->planes[i]);
	free(film->state);
	pthread_mutex_destroy(&film->lock);
	free(film);
}

/* The lock is no part of the film's value: a constant film may be locked. */
static pthread_mutex_t *film_lock(const Film *film)
{
	return &((Film *)film)->lock;
}

Film *film_snapshot(const Film *film)
{
	Film *copy = film_create(film->width, film->height, film->layers);
	pthread_mutex_lock(film_lock(film));
	for (int i = 0; i < FILM_LAYER_COUNT; i++)
		if (film->planes[i])
			memcpy(copy->planes[i], film->planes[i], plane_bytes(film, i));
	memcpy(copy->state, film->state, pixel_count(film));
	copy->passes = film->passes;
	copy->photons = film->photons;
	pthread_mutex_unlock(film_lock(film));
	return copy;
}

int film_width(const Film *film)
{
	return film->width;
}

int film_height(const Film *film)
{
	return film->height;
}

bool film_has(const Film *film, FilmLayer layer)
{
	return film->layers >> layer & 1;
}

const char *film_layer_name(FilmLayer layer)
{
	return layer_info[layer].name;
}

int film_layer_channels(FilmLayer layer)
{
	return layer_info[layer].channels;
}

int film_layer_offset(FilmLayer layer)
{
	return layer_info[layer].offset;
}

const float *film_pixels(const Film *film, FilmLayer layer)
{
	return film->planes[layer];
}

static void store_pixel(Film *film, size_t at, const FilmPixel *pixel)
{
	for (int i = 0; i < FILM_LAYER_COUNT; i++) {
		const LayerInfo *info = &layer_info[i];
		if (film->planes[i])
			memcpy(film->planes[i] + at * (size_t)info->channels,
			       pixel->v + info->offset, (size_t)info->channels * sizeof(float));
	}
}

void film_commit(Film *film, FilmRect rect, const FilmPixel *pixels, bool final)
{
	pthread_mutex_lock(&film->lock);
	for (int y = rect.y0; y < rect.y1; y++)
		for (int x = rect.x0; x < rect.x1; x++) {
			size_t at = (size_t)y * (size_t)film->width + (size_t)x;
			store_pixel(film, at, pixels++);
			film->state[at] = final ? PIXEL_FINAL : PIXEL_STARTED;
		}
	pthread_mutex_unlock(&film->lock);
}

void film_read(const Film *film, int x, int y, FilmPixel *out)
{
	size_t at = (size_t)y * (size_t)film->width + (size_t)x;
	*out = (FilmPixel){{0}};
	for (int i = 0; i < FILM_LAYER_COUNT; i++) {
		const LayerInfo *info = &layer_info[i];
		if (film->planes[i])
			memcpy(out->v + info->offset, film->planes[i] + at * (size_t)info->channels,
			       (size_t)info->channels * sizeof(float));
	}
}

bool film_is_final(const Film *film, int x, int y)
{
	return film->state[(size_t)y * (size_t)film->width + (size_t)x] == PIXEL_FINAL;
}

bool film_is_started(const Film *film, int x, int y)
{
	return film->state[(size_t)y * (size_t)film->width + (size_t)x] != PIXEL_EMPTY;
}

uint32_t film_passes(const Film *film)
{
	return film->passes;
}

void film_add_photons(Film *film, uint64_t photons)
{
	film->photons += photons;
}

uint64_t film_photons(const Film *film)
{
	return film->photons;
}

void film_average(Film *film, const Film *pass)
{
	pthread_mutex_lock(&film->lock);
	float share = 1 / (float)++film->passes;
	for (int i = 0; i < FILM_LAYER_COUNT; i++) {
		bool kept = i == FILM_DEPTH &&
			    film->passes >
				    1; /* infinite depths have no mean: the first pass' stay */
		size_t count = film->planes[i] && !kept ? plane_bytes(film, i) / sizeof(float) : 0;
		float *mean = film->planes[i];
		const float *add = pass->planes[i];
		for (size_t k = 0; k < count; k++)
			mean[k] = share == 1 ? add[k] : mean[k] + (add[k] - mean[k]) * share;
	}
	memcpy(film->state, pass->state, pixel_count(film));
	pthread_mutex_unlock(&film->lock);
}

/* ---- saving ---- */

/* The file: this header, then the states, then each layer's floats, in the machine's own order. */
typedef struct StateHeader {
	char magic[16];
	uint64_t key;
	int32_t width, height;
	uint32_t layers, byte_order, passes, reserved;
	uint64_t photons;
} StateHeader;

static const char state_magic[16] = "cognac film 2\n";
enum { STATE_BYTE_ORDER = 0x01020304 };

static void write_state(const Film *film, uint64_t key, FILE *file)
{
	StateHeader header = {
		.key = key, .width = film->width, .height = film->height, .layers = film->layers,
		.byte_order = STATE_BYTE_ORDER, .passes = film->passes, .photons = film->photons,
	};
	memcpy(header.magic, state_magic, sizeof header.magic);
	fwrite(&header, sizeof header, 1, file);
	fwrite(film->state, 1, pixel_count(film), file);
	for (int i = 0; i < FILM_LAYER_COUNT; i++)
		if (film->planes[i])
			fwrite(film->planes[i], 1, plane_bytes(film, i), file);
}

bool film_save(const Film *film, const char *path, uint64_t key, Diag *diag)
{
	OutputFile file;
	if (!output_file_open(&file, path, diag))
		return false;
	write_state(film, key, file.stream);
	return output_file_commit(&file, diag);
}

static bool header_is_sane(const StateHeader *header)
{
	return memcmp(header->magic, state_magic, sizeof state_magic) == 0 &&
	       header->byte_order == STATE_BYTE_ORDER && header->width > 0 && header->height > 0 &&
	       header->width <= 1 << 20 && header->height <= 1 << 20 &&
	       header->layers >> FILM_LAYER_COUNT == 0;
}

static bool read_planes(Film *film, FILE *file)
{
	if (fread(film->state, 1, pixel_count(film), file) != pixel_count(film))
		return false;
	for (int i = 0; i < FILM_LAYER_COUNT; i++)
		if (film->planes[i] &&
		    fread(film->planes[i], 1, plane_bytes(film, i), file) != plane_bytes(film, i))
			return false;
	/* A first sample alone is not worth keeping: neighbours are needed with it. */
	for (size_t i = 0; i < pixel_count(film); i++)
		film->state[i] = film->state[i] == PIXEL_FINAL ? PIXEL_FINAL : PIXEL_EMPTY;
	return true;
}

Film *film_load(const char *path, uint64_t key, Diag *diag)
{
	FILE *file = fopen(path, "rb");
	if (!file) {
		diag_fail(diag, "cannot open '%s', the state of a render to go on with", path);
		return NULL;
	}
	StateHeader header;
	Film *film = NULL;
	if (fread(&header, sizeof header, 1, file) != 1 || !header_is_sane(&header)) {
		diag_fail(diag, "'%s' is not the state of a render", path);
	} else if (header.key != key) {
		diag_fail(diag,
			  "'%s' is the state of another render: scene, size or switches differ; "
			  "without +C the picture is begun anew",
			  path);
	} else {
		film = film_create(header.width, header.height, header.layers);
		film->passes = header.passes;
		film->photons = header.photons;
		if (!read_planes(film, file)) {
			diag_fail(diag, "'%s' is cut short", path);
			film_destroy(film);
			film = NULL;
		}
	}
	fclose(file);
	return film;
}
