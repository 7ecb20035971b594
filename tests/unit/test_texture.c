/* Colour maps, lists and averages of pigments; layers and weights of textures. */
#include "surface/texture.h"

#include "check.h"
#include "surface/blend.h"

static double value_x(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	return at->p.x;
}

static const PatternClass ALONG_X = {.name = "along x", .value = value_x};

static Pattern along_x(void)
{
	return (Pattern){.class = &ALONG_X, .frequency = 1, .exponent = 1};
}

static SurfacePoint point(double x)
{
	return (SurfacePoint){
		.p = {x, 0, 0}, .normal = {0, 0, -1}, .direction = {0, 0, 1}, .world = {x, 0, 0}};
}

static const ColorEntry MAP[] = {
	{0.2, {1, 0, 0, 0, 0}},
	{0.6, {0, 1, 0, 0.4f, 0.8f}},
	{0.6, {0, 0, 1, 0, 0}},
	{0.8, {1, 1, 1, 1, 1}},
};

static Rgbft map_color(double x)
{
	Pigment pigment = {
		.kind = PIGMENT_COLOR_MAP, .pattern = along_x(), .colors = MAP, .color_count = 4};
	SurfacePoint at = point(x);
	return pigment_color(&pigment, &at);
}

static void test_color_map(void)
{
	CHECK_NEAR(map_color(0.1).r, 1, 0);
	CHECK_NEAR(map_color(0.2).r, 1, 0);
	Rgbft middle = map_color(0.3);
	CHECK_NEAR(middle.r, 0.75, 1e-6);
	CHECK_NEAR(middle.g, 0.25, 1e-6);
	CHECK_NEAR(middle.filter, 0.1, 1e-6);
	CHECK_NEAR(middle.transmit, 0.2, 1e-6);
	/* At a double key the first entry holds, just above it the second. */
	CHECK_NEAR(map_color(0.6).g, 1, 0);
	CHECK_NEAR(map_color(0.6 + 1e-9).b, 1, 1e-6);
	CHECK_NEAR(map_color(0.9).transmit, 1, 0);
}

/* Keys that fall: the first key that is not below the value counts. */
static void test_falling_keys(void)
{
	const ColorEntry entries[] = {
		{0.5, {1, 0, 0, 0, 0}}, {0.1, {0, 1, 0, 0, 0}}, {1, {0, 0, 1, 0, 0}}};
	BlendSpan span = blend_find(entries, sizeof entries[0], 3, 0.2);
	CHECK(span.lower == 0 && span.upper == 0);
	span = blend_find(entries, sizeof entries[0], 3, 0.55);
	CHECK(span.lower == 1 && span.upper == 2);
	CHECK_NEAR(span.weight, 0.5, 1e-12);
}

static Pigment plain(float r, float g, float b)
{
	return (Pigment){.kind = PIGMENT_COLOR, .color = {r, g, b, 0, 0}};
}

static void test_average(void)
{
	Pigment red = plain(1, 0, 0), green = plain(0, 1, 0);
	const PigmentEntry entries[] = {{3, &red}, {1, &green}};
	Pigment average = {.kind = PIGMENT_AVERAGE, .pigments = entries, .pigment_count = 2};
	SurfacePoint at = point(0);
	Rgbft c = pigment_color(&average, &at);
	CHECK_NEAR(c.r, 0.75, 1e-6);
	CHECK_NEAR(c.g, 0.25, 1e-6);
	CHECK(pigment_is_opaque(&average));
	green.color.transmit = 0.5f;
	CHECK(!pigment_is_opaque(&average));
}

static void test_uv(void)
{
	Pigment inner = {
		.kind = PIGMENT_COLOR_MAP, .pattern = along_x(), .colors = MAP, .color_count = 4};
	const PigmentEntry entry = {0, &inner};
	Pigment uv = {.kind = PIGMENT_UV, .pigments = &entry, .pigment_count = 1};
	SurfacePoint at = point(17);
	at.uv = (Vec2){0.4, 0.9};
	CHECK_NEAR(pigment_color(&uv, &at).r, 0.5, 1e-6);
}

static void test_layers(void)
{
	Pigment red = plain(1, 0, 0), glaze = plain(0, 1, 0);
	Finish dull = finish_default(), shiny = finish_default();
	glaze.color.transmit = 0.5f;
	Texture top = {.kind = TEXTURE_PLAIN, .pigment = &glaze, .finish = &shiny};
	Texture bottom = {.kind = TEXTURE_PLAIN, .pigment = &red, .finish = &dull, .next = &top};
	SurfacePoint at = point(0);
	Shading shading;
	texture_shade(&bottom, NULL, &at, &shading);
	CHECK(shading.stack_count == 1 && shading.layer_count == 2);
	CHECK(shading.stacks[0].first == 0 && shading.stacks[0].count == 2);
	CHECK_NEAR(shading.stacks[0].weight, 1, 0);
	CHECK(shading.layers[0].finish == &dull && shading.layers[1].finish == &shiny);
	CHECK_NEAR(shading.layers[0].color.r, 1, 0);
	CHECK_NEAR(shading.layers[1].normal.z, -1, 1e-12);
	CHECK(texture_is_opaque(&bottom));
	CHECK(!texture_is_opaque(&top));
}

static float weight_of(const Shading *shading, const Finish *finish)
{
	float sum = 0;
	for (int i = 0; i < shading->stack_count; i++)
		if (shading->layers[shading->stacks[i].first].finish == finish)
			sum += shading->stacks[i].weight;
	return sum;
}

static void test_texture_map(void)
{
	Pigment gray = plain(0.5f, 0.5f, 0.5f);
	Finish f[3] = {finish_default(), finish_default(), finish_default()};
	Texture t[3];
	for (int i = 0; i < 3; i++)
		t[i] = (Texture){.kind = TEXTURE_PLAIN, .pigment = &gray, .finish = &f[i]};
	const TextureEntry inner_entries[] = {{1, &t[0]}, {1, &t[1]}};
	Texture average = {.kind = TEXTURE_AVERAGE, .textures = inner_entries, .texture_count = 2};
	const TextureEntry entries[] = {{0, &average}, {1, &t[2]}};
	Texture map = {
		.kind = TEXTURE_MAP, .pattern = along_x(), .textures = entries, .texture_count = 2};
	Transform attach = transform_translate(vec3(10, 0, 0));
	SurfacePoint at = point(10.75);
	Shading shading;
	texture_shade(&map, &attach, &at, &shading);
	CHECK_NEAR(weight_of(&shading, &f[2]), 0.75, 1e-6);
	CHECK_NEAR(weight_of(&shading, &f[0]), 0.125, 1e-6);
	CHECK_NEAR(weight_of(&shading, &f[1]), 0.125, 1e-6);
	at = point(11);
	texture_shade(&map, &attach, &at, &shading);
	CHECK(shading.stack_count == 1 && weight_of(&shading, &f[2]) == 1);
}

/* More textures than there is room for: the weights still add up to 1, those of two such as well.
 */
static void test_overflow(void)
{
	enum { MANY = SHADING_MAX_STACKS + 20 };
	Pigment gray = plain(0.5f, 0.5f, 0.5f);
	Finish finish = finish_default();
	Texture t = {.kind = TEXTURE_PLAIN, .pigment = &gray, .finish = &finish};
	TextureEntry entries[MANY];
	for (int i = 0; i < MANY; i++)
		entries[i] = (TextureEntry){1, &t};
	Texture average = {.kind = TEXTURE_AVERAGE, .textures = entries, .texture_count = MANY};
	SurfacePoint at = point(0);
	Shading shading;
	texture_shade(&average, NULL, &at, &shading);
	CHECK(shading.stack_count == SHADING_MAX_STACKS);
	CHECK_NEAR(weight_of(&shading, &finish), 1, 1e-5);
	average.texture_count = SHADING_MAX_STACKS - 20;
	texture_shade_parts((TexturePart[]){{&average, NULL, 0.3}, {&average, NULL, 0.7}}, 2, &at,
			    &shading);
	CHECK(shading.stack_count == SHADING_MAX_STACKS);
	CHECK_NEAR(weight_of(&shading, &finish), 1, 1e-5);
}

int main(void)
{
	test_color_map();
	test_falling_keys();
	test_average();
	test_uv();
	test_layers();
	test_texture_map();
	test_overflow();
	return CHECK_RESULT();
}
