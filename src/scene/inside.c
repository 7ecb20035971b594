#include "scene/inside.h"

void inside_copy(InsideStack *to, const InsideStack *from)
{
	to->count = from->count;
	for (int i = 0; i < from->count; i++)
		to->items[i] = from->items[i];
}

int inside_find(const InsideStack *stack, const Surface *surface)
{
	for (int i = stack->count - 1; i >= 0; i--) {
		const InsideItem *item = &stack->items[i];
		if (item->interior == surface->interior && item->id == surface->id)
			return i;
	}
	return -1;
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

static double ior_of(const Interior *interior, double hue)
{
	return interior ? interior_ior(interior, hue) : 1;
}

/* The index at the top of the stack, leaving out one entry (-1: none). */
static double top_ior(const InsideStack *stack, int except, double hue)
{
	int top = stack->count - 1;
	if (top == except)
		top--;
	return top >= 0 ? ior_of(stack->items[top].interior, hue) : 1;
}

double inside_ratio_at(const InsideStack *stack, int at, const Surface *surface, double hue)
{
	double other = at >= 0 ? top_ior(stack, at, hue) : ior_of(surface->interior, hue);
	return top_ior(stack, -1, hue) / other;
}

double inside_ratio_of_hue(const InsideStack *stack, const Surface *surface, double hue)
{
	return inside_ratio_at(stack, inside_find(stack, surface), surface, hue);
}

double inside_ratio(const InsideStack *stack, const Surface *surface)
{
	return inside_ratio_of_hue(stack, surface, 0.5);
}
