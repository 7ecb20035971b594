#include "scene/inside.h"

#include <string.h>

void inside_copy(InsideStack *to, const InsideStack *from)
{
	to->count = from->count;
	memcpy(to->items, from->items, sizeof *from->items * (size_t)from->count);
}

static int find(const InsideStack *stack, const Surface *surface)
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
	return find(stack, surface) >= 0;
}

void inside_cross(InsideStack *stack, const Surface *surface)
{
	int at = find(stack, surface);
	if (at >= 0) {
		stack->count--;
		memmove(&stack->items[at], &stack->items[at + 1],
			sizeof *stack->items * (size_t)(stack->count - at));
	} else if (stack->count < INSIDE_MAX) {
		stack->items[stack->count++] = (InsideItem){surface->interior, surface->id,
							    surface->hollow};
	}
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

double inside_ratio_of_hue(const InsideStack *stack, const Surface *surface, double hue)
{
	int at = find(stack, surface);
	double own = ior_of(surface->interior, hue);
	return at >= 0 ? top_ior(stack, -1, hue) / top_ior(stack, at, hue)
		       : top_ior(stack, -1, hue) / own;
}

double inside_ratio(const InsideStack *stack, const Surface *surface)
{
	return inside_ratio_of_hue(stack, surface, 0.5);
}
