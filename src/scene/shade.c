#include "scene/shade.h"

#include <string.h>

#include "geom/csg.h"

void shade_point_init(ShadePoint *point, const Ray *ray, const Hit *hit)
{
	Vec3 world = ray_at(ray, hit->t);
	Vec3 normal = hit_shading_normal(hit, world);
	point->hit = hit;
	point->surface = hit->shape->owner;
	point->back = vec3_dot(normal, ray->direction) > 0;
	point->at = (SurfacePoint){
		.p = world, .world = world, .direction = ray->direction,
		.normal = point->back ? vec3_neg(normal) : normal,
		.uv = point->surface->uv_mapping ? hit_uv(hit, world) : (Vec2){world.x, world.y},
	};
}

/* Appends the shading of one of several textures, with its weight. */
static void append_shading(Shading *to, const Shading *from, double weight)
{
	if (to->layer_count + from->layer_count > SHADING_MAX_LAYERS ||
	    to->stack_count + from->stack_count > SHADING_MAX_STACKS)
		return;
	memcpy(&to->layers[to->layer_count], from->layers,
	       sizeof *from->layers * (size_t)from->layer_count);
	for (int i = 0; i < from->stack_count; i++) {
		ShadingStack stack = from->stacks[i];
		stack.first += to->layer_count;
		stack.weight *= (float)weight;
		to->stacks[to->stack_count++] = stack;
	}
	to->layer_count += from->layer_count;
}

static void shade_one_texture(const ShadePoint *point, int number, Shading *out)
{
	const Surface *surface = point->surface;
	if (number >= 0 && number < surface->texture_count && surface->textures[number])
		texture_shade(surface->textures[number], surface->numbered_attach, &point->at, out);
	else
		texture_shade(surface->texture, surface->attach, &point->at, out);
}

static void shade_numbered(const ShadePoint *point, const ShapeTextures *covering, Shading *out)
{
	if (covering->count == 1) {
		shade_one_texture(point, covering->numbers[0], out);
		return;
	}
	out->layer_count = out->stack_count = 0;
	for (int i = 0; i < covering->count; i++) {
		Shading one;
		shade_one_texture(point, covering->numbers[i], &one);
		append_shading(out, &one, covering->weights[i]);
	}
}

/* ---- cutaway_textures ---- */

enum { CUTAWAY_MOST = 16 }; /* textures at a place: those of further parts are left out */

typedef struct Cut {
	const Surface *parts[CUTAWAY_MOST];
	int count;
} Cut;

/* The shape's primitives that hold the place, unless something around them does not; what is cut
 * off within the shape and what shows the parts it cuts has nothing of its own. */
static void find_cut(const Shape *shape, Vec3 place, Cut *cut)
{
	if (!shape_inside(shape, place))
		return;
	const Csg *csg = csg_is(shape) ? shape->data : NULL;
	for (int i = 0; csg && i < csg->count; i++)
		find_cut(csg->children[i], place, cut);
	const Surface *own = shape->owner;
	if (!csg && !shape->inverted && !own->cutaway && cut->count < CUTAWAY_MOST)
		cut->parts[cut->count++] = own;
}

/* False where nothing is cut: the texture is the face's own. */
static bool shade_cut(const ShadePoint *point, Shading *out)
{
	const Cutaway *cutaway = point->surface->cutaway;
	Cut cut = {.count = 0};
	for (int i = 0; i < cutaway->count; i++)
		find_cut(cutaway->parts[i], point->at.world, &cut);
	out->layer_count = out->stack_count = 0;
	for (int i = 0; i < cut.count; i++) {
		const Surface *part = cut.parts[i];
		bool inner = point->back && part->interior_texture;
		Shading one;
		texture_shade(inner ? part->interior_texture : part->texture, part->attach,
			      &point->at, &one);
		append_shading(out, &one, 1.0 / cut.count);
	}
	return cut.count > 0;
}

void shade_textures(const ShadePoint *point, Shading *out)
{
	const Surface *surface = point->surface;
	ShapeTextures covering;
	if (point->back && surface->interior_texture)
		texture_shade(surface->interior_texture, surface->attach, &point->at, out);
	else if (surface->cutaway && shade_cut(point, out))
		return;
	else if (surface->texture_count && hit_textures(point->hit, point->at.world, &covering))
		shade_numbered(point, &covering, out);
	else
		texture_shade(surface->texture, surface->attach, &point->at, out);
}

bool shade_light_reaches(const Light *light, const Surface *surface)
{
	if (light->group)
		return light->group == surface->light_group;
	return surface->light_group == 0 || surface->global_lights;
}

static Rgb stack_transmittance(const Shading *shading, const ShadingStack *stack)
{
	Rgb through = rgb_all(stack->weight);
	for (int i = 0; i < stack->count; i++)
		through = rgb_mul(through,
				  rgbft_transmittance(shading->layers[stack->first + i].color));
	return through;
}

Rgb shade_transmittance(const Shading *shading)
{
	Rgb sum = {0, 0, 0};
	for (int i = 0; i < shading->stack_count; i++)
		sum = rgb_add(sum, stack_transmittance(shading, &shading->stacks[i]));
	return sum;
}

Rgb shade_attenuation(const Interior *interior, double distance)
{
	if (!interior || interior->fade_power <= 0 || interior->fade_distance <= 0)
		return rgb_all(1);
	float depth = (float)(distance / interior->fade_distance);
	Rgb color = interior->fade_color;
	if (interior->fade_power >= 1000)
		return rgb(expf(-(1 - color.r) * depth), expf(-(1 - color.g) * depth),
			   expf(-(1 - color.b) * depth));
	float left = 1 / (1 + powf(depth, (float)interior->fade_power));
	return rgb_lerp(color, rgb_all(1), left);
}
