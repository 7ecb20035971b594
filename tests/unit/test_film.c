/* The film keeps what is put in, snapshots it, saves and loads its state. */
#include "render/film.h"

#include <stdlib.h>
#include <unistd.h>

#include "check.h"

static FilmPixel pixel_of(float value)
{
	FilmPixel pixel;
	for (int i = 0; i < FILM_CHANNELS; i++)
		pixel.v[i] = value + (float)i;
	return pixel;
}

static void check_pixels(const Film *film)
{
	const float *color = film_pixels(film, FILM_COLOR), *depth = film_pixels(film, FILM_DEPTH);
	CHECK_NEAR(color[(2 * 5 + 3) * 4 + 1], 101, 0);
	CHECK_NEAR(depth[2 * 5 + 3], 100 + film_layer_offset(FILM_DEPTH), 0);
	CHECK(film_pixels(film, FILM_NORMAL) == NULL && !film_has(film, FILM_NORMAL));
	CHECK(film_is_final(film, 3, 2) && !film_is_started(film, 4, 2));
}

static void check_state(const Film *film, Diag *diag)
{
	char path[] = "test_film_XXXXXX";
	int file = mkstemp(path);
	CHECK(file >= 0);
	close(file);
	CHECK(film_save(film, path, 42, diag));
	Film *loaded = film_load(path, 42, diag);
	CHECK(loaded != NULL);
	if (loaded) {
		check_pixels(loaded);
		CHECK(!film_is_started(loaded, 0, 0)); /* was not final */
	}
	film_destroy(loaded);
	CHECK(diag_errors(diag) == 0);
	CHECK(film_load(path, 43, diag) == NULL);
	CHECK(truncate(path, 100) == 0);
	CHECK(film_load(path, 42, diag) == NULL);
	CHECK(truncate(path, 10) == 0);
	CHECK(film_load(path, 42, diag) == NULL);
	CHECK(diag_errors(diag) == 3);
	remove(path);
	CHECK(film_load(path, 42, diag) == NULL);
}

int main(void)
{
	Diag *diag = diag_create(NULL);
	Film *film = film_create(5, 4, 1u << FILM_DEPTH);
	FilmPixel pixel = pixel_of(100);
	film_commit(film, (FilmRect){3, 2, 4, 3}, &pixel, true);
	film_commit(film, (FilmRect){0, 0, 1, 1}, &pixel, false);
	check_pixels(film);
	CHECK(film_is_started(film, 0, 0) && !film_is_final(film, 0, 0));
	FilmPixel back;
	film_read(film, 3, 2, &back);
	CHECK_NEAR(back.v[3], 103, 0);
	Film *copy = film_snapshot(film);
	check_pixels(copy);
	film_destroy(copy);
	check_state(film, diag);
	film_destroy(film);
	diag_destroy(diag);
	return CHECK_RESULT();
}
