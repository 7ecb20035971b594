#include "lang/value.h"

double value_to_float(Value a)
{
	return a.kind == VALUE_FLOAT ? a.number : a.v[0];
}

Vec3 value_to_vec3(Value a)
{
	return a.kind == VALUE_FLOAT ? vec3_all(a.number) : vec3(a.v[0], a.v[1], a.v[2]);
}

Vec2 value_to_vec2(Value a)
{
	return a.kind == VALUE_FLOAT ? (Vec2){a.number, a.number} : (Vec2){a.v[0], a.v[1]};
}

Rgbft value_to_rgbft(Value a)
{
	if (a.kind == VALUE_FLOAT) {
		float f = (float)a.number;
		return rgbft(f, f, f, f, f);
	}
	return rgbft((float)a.v[0], (float)a.v[1], (float)a.v[2], (float)a.v[3], (float)a.v[4]);
}

static const char *const vector_names[6] = {
	"a vector", "a vector", "a vector of 2", "a vector of 3", "a vector of 4", "a vector of 5",
};

static const char *const kind_names[VALUE_KIND_COUNT] = {
	[VALUE_NONE] = "nothing",
	[VALUE_FLOAT] = "a float",
	[VALUE_VECTOR] = "a vector",
	[VALUE_COLOR] = "a colour",
	[VALUE_STRING] = "a string",
	[VALUE_ARRAY] = "an array",
	[VALUE_SPLINE] = "a spline",
	[VALUE_FUNCTION] = "a function",
	[VALUE_VECTOR_FUNCTION] = "a vector function",
	[VALUE_EXPRESSION] = "an expression of function arguments",
	[VALUE_FILE] = "a file",
	[VALUE_MACRO] = "a macro",
	[VALUE_OBJECT] = "an object",
	[VALUE_TEXTURE] = "a texture",
	[VALUE_PIGMENT] = "a pigment",
	[VALUE_NORMAL] = "a normal",
	[VALUE_FINISH] = "a finish",
	[VALUE_INTERIOR] = "an interior",
	[VALUE_MATERIAL] = "a material",
	[VALUE_MEDIA] = "a media",
	[VALUE_DENSITY] = "a density",
	[VALUE_CAMERA] = "a camera",
	[VALUE_FOG] = "a fog",
	[VALUE_RAINBOW] = "a rainbow",
	[VALUE_SKY_SPHERE] = "a sky_sphere",
	[VALUE_TRANSFORM] = "a transform",
	[VALUE_COLOR_MAP] = "a color_map",
	[VALUE_PIGMENT_MAP] = "a pigment_map",
	[VALUE_NORMAL_MAP] = "a normal_map",
	[VALUE_SLOPE_MAP] = "a slope_map",
	[VALUE_TEXTURE_MAP] = "a texture_map",
	[VALUE_DENSITY_MAP] = "a density_map",
	[VALUE_ESTIMATOR] = "an estimator",
};

const char *value_describe(Value a)
{
	if (a.kind == VALUE_VECTOR && a.size >= 0 && a.size <= 5)
		return vector_names[a.size];
	if ((unsigned)a.kind >= VALUE_KIND_COUNT)
		return "something unknown";
	return kind_names[a.kind];
}
