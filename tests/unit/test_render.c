/* Whole renders of scenes whose light is known, and the same bits from any number of threads. */
#include "base/parallel.h"

#include "check.h"
#include "scene_check.h"

static Film *render_scene(SceneBuilder *builder, const RenderOptions *options, int width,
			  int height)
{
	Scene *scene = scene_freeze(builder);
	Film *film = film_create(width, height, ~0u >> (32 - FILM_LAYER_COUNT));
	RenderStatistics statistics;
	CHECK(render_image(scene, options, film, NULL, &statistics) == RENDER_DONE);
	CHECK(statistics.pixels > 0 && statistics.eye_rays >= statistics.pixels);
	scene_destroy(scene);
	return film;
}

/* Everything glows with 0.5; whatever stands in there and keeps light's sum cannot be told from its
 * surroundings. */
static void add_furnace(SceneBuilder *builder)
{
	Finish glow = scene_finish();
	glow.emission = rgb_all(0.5f);
	Object *walls = scene_add(builder, &box_class,
				  scene_box(builder, vec3(-9, -9, -9), vec3(9, 9, 9)),
				  scene_texture(builder, rgbft(1, 1, 1, 0, 0), glow));
	walls->flags.hollow = ON;
}

static void check_furnace(Diag *diag)
{
	SceneBuilder builder = scene_start(diag);
	add_furnace(&builder);
	builder.settings.adc_bailout = 1e-4; /* what is cut off stays under the tolerance */
	Finish glass = scene_finish();
	glass.reflection.max = rgb_all(1);
	glass.reflection.fresnel = glass.conserve_energy = true;
	Object *ball = scene_add(&builder, &sphere_class,
				 scene_sphere(&builder, vec3(0, 0, 0), 1.5),
				 scene_texture(&builder, rgbft(1, 1, 1, 0, 1), glass));
	Interior interior = interior_default();
	interior.ior = 1.5f;
	ball->interior = &interior;
	RenderOptions options = render_options_default();
	Film *film = render_scene(&builder, &options, 12, 12);
	const float *color = film_pixels(film, FILM_COLOR);
	for (int i = 0; i < 12 * 12 * 4; i++)
		CHECK_NEAR(color[i], i % 4 == 3 ? 1 : 0.5, 4e-3);
	film_destroy(film);
}

/* A mirror of 0.3 and a half clear pane of no index in the furnace: known shares of its light. */
static void check_mirror_and_pane(Diag *diag)
{
	SceneBuilder builder = scene_start(diag);
	add_furnace(&builder);
	Finish mirror = scene_finish();
	mirror.reflection.min = mirror.reflection.max = rgb_all(0.3f);
	scene_add(&builder, &box_class, scene_box(&builder, vec3(-3, -3, 2), vec3(0, 3, 3)),
	          scene_texture(&builder, rgbft(1, 1, 1, 0, 0), mirror));
	scene_add(&builder, &box_class, scene_box(&builder, vec3(0, -3, 2), vec3(3, 3, 3)),
	          scene_texture(&builder, rgbft(0.5f, 1, 0, 0.5f, 0.25f), scene_finish()));
	RenderOptions options = render_options_default();
	Film *film = render_scene(&builder, &options, 2, 1);
	const float *color = film_pixels(film, FILM_COLOR);
	CHECK_NEAR(color[0], 0.15, 1e-6);
	CHECK_NEAR(color[4], 0.5 * 0.5 * 0.5, 1e-6);
	CHECK_NEAR(color[5], 0.5 * 0.75 * 0.75, 1e-6);
	CHECK_NEAR(color[6], 0.5 * 0.25 * 0.25, 1e-6);
	CHECK_NEAR(film_pixels(film, FILM_DEPTH)[0], 7 / cos(atan(0.25)), 1e-5);
	CHECK_NEAR(film_pixels(film, FILM_NORMAL)[2], -1, 1e-6);
	film_destroy(film);
}

/* A pane of glass before a wall of light, black behind the eye: of all bounces together (1 - R) /
 * (1 + R) comes through. Inside another object POV-Ray's panes mirror outside only: 1 - R, but not
 * in scenes of the extension. */
static void check_fresnel_slab(Diag *diag, bool enclosed, bool extension)
{
	SceneBuilder builder = scene_start(diag);
	Finish glow = scene_finish(), glass = scene_finish();
	glow.emission = rgb_all(1);
	glass.reflection.max = rgb_all(1);
	glass.reflection.fresnel = glass.conserve_energy = true;
	scene_add(&builder, &plane_class, scene_plane(&builder, vec3(0, 0, -1), -20),
	          scene_texture(&builder, rgbft(1, 1, 1, 0, 0), glow));
	Object *pane = scene_add(&builder, &box_class,
				 scene_box(&builder, vec3(-90, -90, 0), vec3(90, 90, 1)),
				 scene_texture(&builder, rgbft(1, 1, 1, 0, 1), glass));
	Interior interior = interior_default();
	interior.ior = 1.5f;
	pane->interior = &interior;
	if (enclosed)
		scene_add(&builder, &sphere_class, scene_sphere(&builder, vec3(0, 0, 0), 900),
		          scene_texture(&builder, rgbft(1, 1, 1, 0, 1), scene_finish()));
	builder.settings.cognac = extension;
	builder.camera.direction = vec3(0, 1, 1); /* 45 degrees onto the pane */
	RenderOptions options = render_options_default();
	Film *film = render_scene(&builder, &options, 1, 1);
	double outer = atan(1), inner = asin(sin(outer) / 1.5);
	double s = sin(outer - inner) / sin(outer + inner),
	       p = tan(outer - inner) / tan(outer + inner);
	double reflectance = (s * s + p * p) / 2;
	double bounces = enclosed && !extension ? 1 : 1 + reflectance;
	CHECK_NEAR(film_pixels(film, FILM_COLOR)[0], (1 - reflectance) / bounces, 1e-4);
	film_destroy(film);
}

/* A glass ball of index n and radius R gathers light from infinity at n R / (2 (n - 1)) from its
 * centre: seen through it, a spot of that place covers all of the middle. */
static void check_ball_lens(Diag *diag)
{
	SceneBuilder builder = scene_start(diag);
	const double n = 1.5, focus = n / (2 * (n - 1));
	builder.camera.kind = CAMERA_ORTHOGRAPHIC;
	builder.camera.right = vec3(0.3, 0, 0);
	builder.camera.up = vec3(0, 0.3, 0);
	Finish glow = scene_finish();
	glow.emission = rgb_all(1);
	Object *ball = scene_add(&builder, &sphere_class, scene_sphere(&builder, vec3(0, 0, 0), 1),
	                         scene_texture(&builder, rgbft(1, 1, 1, 0, 1), scene_finish()));
	Interior interior = interior_default();
	interior.ior = (float)n;
	ball->interior = &interior;
	scene_add(&builder, &box_class,
		  scene_box(&builder, vec3(-0.01, -0.01, focus), vec3(0.01, 0.01, focus + 0.1)),
		  scene_texture(&builder, rgbft(1, 1, 1, 0, 0), glow));
	RenderOptions options = render_options_default();
	Film *film = render_scene(&builder, &options, 9, 9);
	for (int i = 0; i < 81; i++)
		CHECK_NEAR(film_pixels(film, FILM_COLOR)[4 * i], 1, 1e-6);
	film_destroy(film);
}

/* A white floor, and before its right half a pane that only light sees. */
static void add_floor_and_pane(SceneBuilder *builder, Rgbft color)
{
	Finish matt = scene_finish();
	matt.diffuse = 0.5f;
	scene_add(builder, &plane_class, scene_plane(builder, vec3(0, 0, -1), -2),
		  scene_texture(builder, rgbft(1, 1, 1, 0, 0), matt));
	Object *pane = scene_add(builder, &box_class,
				 scene_box(builder, vec3(0, -9, 0), vec3(9, 9, 0.5)),
				 scene_texture(builder, color, scene_finish()));
	pane->flags.no_image = ON;
}

/* Light that falls on a white floor straight below a lamp, and through a red filter. */
static void check_lamp(Diag *diag)
{
	SceneBuilder builder = scene_start(diag);
	add_floor_and_pane(&builder, rgbft(1, 0, 0, 0.5f, 0));
	Light light = light_default();
	light.position = vec3(0, 0, -1000);
	light.parallel = true;
	scene_add_light(&builder, &light);
	RenderOptions options = render_options_default();
	Film *film = render_scene(&builder, &options, 2, 1);
	const float *color = film_pixels(film, FILM_COLOR);
	CHECK_NEAR(color[0], 0.5, 1e-6);
	CHECK_NEAR(color[4], 0.5 * 0.25, 1e-6);
	CHECK_NEAR(color[5], 0, 1e-6);
	film_destroy(film);
}

/* A dim wall before a bright one, both before the eye and in a mirror of 0.5 on the left. */
static void check_hidden(Diag *diag, Tristate no_image, Tristate no_reflection,
			 const double expected[2])
{
	SceneBuilder builder = scene_start(diag);
	Finish mirror = scene_finish(), dim = scene_finish(), bright = scene_finish();
	mirror.reflection.min = mirror.reflection.max = rgb_all(0.5f);
	dim.emission = rgb_all(0.2f);
	bright.emission = rgb_all(0.8f);
	scene_add(&builder, &box_class, scene_box(&builder, vec3(-9, -9, 0), vec3(0, 9, 1)),
		  scene_texture(&builder, rgbft(1, 1, 1, 0, 0), mirror));
	Object *room = scene_add(&builder, &box_class,
				 scene_box(&builder, vec3_all(-20), vec3_all(20)),
				 scene_texture(&builder, rgbft(1, 1, 1, 0, 0), dim));
	room->flags.no_image = no_image;
	room->flags.no_reflection = no_reflection;
	scene_add(&builder, &box_class, scene_box(&builder, vec3_all(-30), vec3_all(30)),
		  scene_texture(&builder, rgbft(1, 1, 1, 0, 0), bright));
	RenderOptions options = render_options_default();
	Film *film = render_scene(&builder, &options, 2, 1);
	CHECK_NEAR(film_pixels(film, FILM_COLOR)[0], expected[0], 1e-6);
	CHECK_NEAR(film_pixels(film, FILM_COLOR)[4], expected[1], 1e-6);
	film_destroy(film);
}

/* Black fog weakens what is seen, and the light of a lamp with media_attenuation, but not within a
 * pane that is not hollow. */
static void check_lamp_in_fog(Diag *diag, bool attenuation)
{
	const double distance = 4;
	SceneBuilder builder = scene_start(diag);
	add_floor_and_pane(&builder, rgbft(1, 1, 1, 0, 1));
	Fog fog = {.distance = distance};
	builder.fogs = (const Fog *[]){&fog};
	builder.fog_count = 1;
	Light light = light_default();
	light.position = vec3(0, 0, -6);
	light.parallel = true;
	light.media_attenuation = attenuation;
	scene_add_light(&builder, &light);
	RenderOptions options = render_options_default();
	Film *film = render_scene(&builder, &options, 2, 1);
	const float *color = film_pixels(film, FILM_COLOR);
	double seen = 0.5 * exp(-7 / cos(atan(0.25)) / distance);
	CHECK_NEAR(color[0], seen * (attenuation ? exp(-8 / distance) : 1), 1e-6);
	CHECK_NEAR(color[4], seen * (attenuation ? exp(-7.5 / distance) : 1), 1e-6);
	film_destroy(film);
}

/* Something of everything that draws random numbers. */
static void build_busy(SceneBuilder *builder)
{
	Finish shiny = finish_default();
	shiny.reflection.min = shiny.reflection.max = rgb_all(0.3f);
	shiny.crand = 0.1f;
	shiny.specular = 0.5f;
	for (int i = 0; i < 12; i++)
		scene_add(builder, &sphere_class,
			  scene_sphere(builder, vec3(i % 4 - 1.5, i / 4 - 1, i % 3), 0.4),
			  scene_texture(builder,
					rgbft(0.2f * (float)(i % 5), 0.5f, 1, 0, i % 3 ? 0 : 0.6f),
					shiny));
	scene_add(builder, &plane_class, scene_plane(builder, vec3(0, 1, 0), -1.5),
	          scene_texture(builder, rgbft(1, 0.9f, 0.5f, 0, 0), finish_default()));
	Light light = light_default();
	light.position = vec3(3, 8, -5);
	light.area = light.jitter = true;
	light.axis1 = vec3(2, 0, 0);
	light.axis2 = vec3(0, 0, 2);
	light.size1 = light.size2 = 3;
	light.adaptive = 1;
	scene_add_light(builder, &light);
	builder->settings = settings_default();
	builder->camera.aperture = 0.2;
	builder->camera.focal_distance = 5;
	builder->camera.blur_samples = 4;
}

static Film *render_busy(Diag *diag, RenderOptions options, int threads)
{
	SceneBuilder builder = scene_start(diag);
	build_busy(&builder);
	parallel_set_threads(threads);
	return render_scene(&builder, &options, 44, 36);
}

static void check_same(const Film *a, const Film *b, FilmRect rect)
{
	for (int y = rect.y0; y < rect.y1; y++)
		for (int x = rect.x0; x < rect.x1; x++) {
			FilmPixel left, right;
			film_read(a, x, y, &left);
			film_read(b, x, y, &right);
			CHECK(memcmp(&left, &right, sizeof left) == 0);
		}
}

static void check_threads(Diag *diag)
{
	for (int method = 0; method <= 2; method++) {
		RenderOptions options = render_options_default();
		options.antialias = method > 0;
		options.sampling_method = method;
		options.threshold = 0.05;
		Film *one = render_busy(diag, options, 1), *many = render_busy(diag, options, 5);
		check_same(one, many, (FilmRect){0, 0, 44, 36});
		CHECK(film_is_final(one, 43, 35));
		options.region = (FilmRect){10, 10, 41, 34};
		if (method != 2) { /* method 2 shares corners of whole tiles only */
			Film *part = render_busy(diag, options, 3);
			check_same(one, part, options.region);
			CHECK(!film_is_started(part, 9, 20) && !film_is_started(part, 30, 34));
			film_destroy(part);
		}
		film_destroy(one);
		film_destroy(many);
	}
	parallel_set_threads(0);
}

static void check_stop_and_resume(Diag *diag)
{
	RenderOptions options = render_options_default();
	options.antialias = true;
	Film *whole = render_busy(diag, options, 2);
	SceneBuilder builder = scene_start(diag);
	build_busy(&builder);
	Scene *scene = scene_freeze(&builder);
	Film *film = film_create(44, 36, ~0u >> (32 - FILM_LAYER_COUNT));
	int stop = 1;
	RenderCallbacks callbacks = {.stop = &stop};
	CHECK(render_image(scene, &options, film, &callbacks, NULL) == RENDER_STOPPED);
	RenderOptions top = options;
	top.region = (FilmRect){0, 0, 44, 21};
	CHECK(render_image(scene, &top, film, NULL, NULL) == RENDER_DONE);
	CHECK(film_is_final(film, 5, 20) && !film_is_final(film, 5, 21));
	CHECK(render_image(scene, &options, film, NULL, NULL) == RENDER_DONE);
	check_same(whole, film, (FilmRect){0, 0, 44, 36});
	film_destroy(film);
	film_destroy(whole);
	scene_destroy(scene);
}

int main(void)
{
	Diag *diag = diag_create(NULL);
	check_furnace(diag);
	check_mirror_and_pane(diag);
	check_fresnel_slab(diag, false, false);
	check_fresnel_slab(diag, true, false);
	check_fresnel_slab(diag, true, true);
	check_ball_lens(diag);
	check_lamp(diag);
	check_hidden(diag, OFF, OFF, (double[]){0.1, 0.2});
	check_hidden(diag, ON, OFF, (double[]){0.1, 0.8});
	check_hidden(diag, OFF, ON, (double[]){0.4, 0.2});
	check_lamp_in_fog(diag, false);
	check_lamp_in_fog(diag, true);
	check_threads(diag);
	check_stop_and_resume(diag);
	CHECK(diag_errors(diag) == 0);
	diag_destroy(diag);
	return CHECK_RESULT();
}
