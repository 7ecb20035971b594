#include "scene/inside.h"

void inside_start(InsideStack *stack, const Accel *accel, Vec3 place)
{
	const Shape *around[INSIDE_MAX];
	int count = accel_containing(accel, place, around, INSIDE_MAX);
	stack->count = 0;
	for (int i = 0; i < count; i++)
		if (!inside_has(stack, around[i]->owner))
			inside_cross(stack, around[i]->owner);
}

void inside_copy(InsideStack *to, const InsideStack *from)
{
	to->count = from->count;
	for (int i = 0; i < from->count; i++)
		to->items[i] = from->items[i];
}

bool inside_has(const InsideStack *stack, const Surface *surface)
{
	return inside_find(stack, surface) >= 0;
}

void inside_cross_at(InsideStack *stack, int at, const Surface *surface)
{
	if (at >= 0) {
		stack->count--;
		for (int i = at; i < stack->count; i++)
			stack->items[i] = stack->items[i + 1];
	} else if (stack->count < INSIDE_MAX) {
		stack->items[stack->count++] = (InsideItem){surface->interior, surface->id,
							    surface->hollow};
	}
}

void inside_cross(InsideStack *stack, const Surface *surface)
{
	inside_cross_at(stack, inside_find(stack, surface), surface);
}

bool inside_is_open(const InsideStack *stack)
{
	for (int i = 0; i < stack->count; i++)
		if (!stack->items[i].hollow)
			return false;
	return true;
}

double inside_ratio_of_hue(const InsideStack *stack, const Surface *surface, double hue)
{
	return inside_ratio_at(stack, inside_find(stack, surface), surface, hue);
}

double inside_mirror_ratio_of_hue(const InsideStack *stack, const Surface *surface, double hue)
{
	int at = inside_find(stack, surface);
	if (at < 0 || stack->count == 1)
		return inside_ratio_at(stack, at, surface, hue);
	double own = surface->interior ? interior_ior(surface->interior, hue) : 1;
	return own / inside_top_ior(stack, -1, hue);
}

double inside_ratio(const InsideStack *stack, const Surface *surface)
{
	return inside_ratio_of_hue(stack, surface, 0.5);
}
