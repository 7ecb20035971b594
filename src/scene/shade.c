#include "scene/shade.h"

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

static TexturePart numbered_part(const Surface *surface, int number, double weight)
{
	bool own = number < 0 || number >= surface->texture_count || !surface->textures[number];
	return own ? (TexturePart){surface->texture, surface->attach, weight}
		   : (TexturePart){surface->textures[number], surface->numbered_attach, weight};
}

static void shade_numbered(const ShadePoint *point, const ShapeTextures *covering, Shading *out)
{
	TexturePart parts[SHAPE_MAX_TEXTURES];
	for (int i = 0; i < covering->count; i++)
		parts[i] = numbered_part(point->surface, covering->numbers[i],
					 covering->weights[i]);
	texture_shade_parts(parts, covering->count, &point->at, out);
}

/* ---- cutaway_textures ---- */

enum { CUTAWAY_MOST = 16 }; /* textures at a place: those of further parts are left out */

typedef struct Cut {
	const ShadePoint *point;
	TexturePart parts[CUTAWAY_MOST];
	int count;
} Cut;

static void add_cut(Cut *cut, const Surface *part)
{
	bool inner = cut->point->back && part->interior_texture;
	if (part->cutaway || cut->count == CUTAWAY_MOST)
		return;
	cut->parts[cut->count++] = (TexturePart){inner ? part->interior_texture : part->texture,
						 part->attach, 1};
}

/* The shape's primitives that hold the place, unless something around them does not; what is cut
 * off within the shape and what shows the parts it cuts has nothing of its own. */
static void find_cut(const Shape *shape, Cut *cut)
{
	if (!shape_inside(shape, cut->point->at.world))
		return;
	const Csg *csg = csg_is(shape) ? shape->data : NULL;
	for (int i = 0; csg && i < csg->count; i++)
		find_cut(csg->children[i], cut);
	if (!csg && !shape->inverted)
		add_cut(cut, shape->owner);
}

/* False where nothing is cut: the texture is the face's own. */
static bool shade_cut(const ShadePoint *point, Shading *out)
{
	const Cutaway *cutaway = point->surface->cutaway;
	Cut cut = {.point = point};
	for (int i = 0; i < cutaway->count; i++)
		find_cut(cutaway->parts[i], &cut);
	if (cut.count > 0)
		texture_shade_parts(cut.parts, cut.count, &point->at, out);
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
