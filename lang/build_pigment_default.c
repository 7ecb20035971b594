#include "lang/build_pigment_default.h"

#include <string.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof((array)[0])))

static const ColorEntry GRAY[] = {{0, {0, 0, 0, 0, 0}}, {1, {1, 1, 1, 0, 0}}};

static const ColorEntry AGATE[] = {
	{0.0, {1, 1, 1, 0, 0}},          {0.5, {0.95f, 0.75f, 0.5f, 0, 0}},
	{0.5, {0.9f, 0.7f, 0.5f, 0, 0}}, {0.6, {0.9f, 0.7f, 0.4f, 0, 0}},
	{0.6, {1, 0.7f, 0.4f, 0, 0}},    {1.0, {0.6f, 0.3f, 0, 0, 0}},
};

static const ColorEntry BOZO[] = {
	{0.4, {1, 1, 1, 0, 0}}, {0.4, {0, 1, 0, 0, 0}}, {0.6, {0, 1, 0, 0, 0}},
	{0.6, {0, 0, 1, 0, 0}}, {0.8, {0, 0, 1, 0, 0}}, {0.8, {1, 0, 0, 0, 0}},
	{1.0, {1, 0, 0, 0, 0}},
};

static const ColorEntry MANDEL[] = {
	{0.001, {0, 0, 0, 0, 0}}, {0.001, {0, 1, 1, 0, 0}}, {0.012, {1, 1, 0, 0, 0}},
	{0.015, {1, 0, 1, 0, 0}}, {0.1, {0, 1, 1, 0, 0}},
};

static const ColorEntry MARBLE[] = {
	{0.0, {0.9f, 0.8f, 0.8f, 0, 0}}, {0.9, {0.9f, 0.08f, 0.08f, 0, 0}}, {0.9, {0, 0, 0, 0, 0}},
};

static const ColorEntry RADIAL[] = {
	{0.0, {0, 1, 1, 0, 0}},
	{0.333, {1, 1, 0, 0, 0}},
	{0.666, {1, 0, 1, 0, 0}},
	{1.0, {0, 1, 1, 0, 0}},
};

static const ColorEntry WOOD[] = {
	{0.6, {0.666f, 0.312f, 0.2f, 0, 0}}, {0.6, {0.4f, 0.1333f, 0.0666f, 0, 0}},
};

typedef struct DefaultMap {
	const char *pattern;
	const ColorEntry *colors;
	int count;
} DefaultMap;

/* Every other pattern is grey. */
static const DefaultMap DEFAULT_MAPS[] = {
	{"agate", AGATE, COUNT(AGATE)},    {"bozo", BOZO, COUNT(BOZO)},
	{"mandel", MANDEL, COUNT(MANDEL)}, {"marble", MARBLE, COUNT(MARBLE)},
	{"radial", RADIAL, COUNT(RADIAL)}, {"wood", WOOD, COUNT(WOOD)},
};

static const Rgbft LIST_COLORS[] = {
	{1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, 0, 1, 0, 0},
	{1, 1, 0, 0, 0}, {0, 1, 1, 0, 0}, {1, 0, 1, 0, 0},
};
/* checker, hexagon, object */
static const Rgbft SHORT_LIST_COLORS[] = {{0, 0, 1, 0, 0}, {0, 1, 0, 0, 0}, {1, 0, 0, 0, 0}};
static const Rgbft BRICK_COLORS[] = {{0.5f, 0.5f, 0.5f, 0, 0}, {0.6f, 0.15f, 0.15f, 0, 0}};

void build_default_map(Pigment *pigment)
{
	pigment->kind = PIGMENT_COLOR_MAP;
	pigment->colors = GRAY;
	pigment->color_count = COUNT(GRAY);
	for (int i = 0; i < COUNT(DEFAULT_MAPS); i++)
		if (strcmp(DEFAULT_MAPS[i].pattern, pigment->pattern.class->name) == 0) {
			pigment->colors = DEFAULT_MAPS[i].colors;
			pigment->color_count = DEFAULT_MAPS[i].count;
		}
}

Rgbft build_default_list_color(const Pattern *pattern, int i)
{
	if (strcmp(pattern->class->name, "brick") == 0)
		return BRICK_COLORS[i % COUNT(BRICK_COLORS)];
	if (pattern->class->list <= COUNT(SHORT_LIST_COLORS))
		return SHORT_LIST_COLORS[i % COUNT(SHORT_LIST_COLORS)];
	return LIST_COLORS[i % COUNT(LIST_COLORS)];
}
