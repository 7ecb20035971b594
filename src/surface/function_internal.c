#include "surface/function_internal.h"

#include "surface/function_natives.h"

double function_internal_limit(double value)
{
	return value > 10 ? 10 : value < -10 ? -10 : value;
}

static const InternalFunction *find_in(const InternalFunction *rows, int number)
{
	for (; rows->eval; rows++)
		if (rows->number == number)
			return rows;
	return NULL;
}

const Function *function_internal_find(Arena *arena, int number, int noise_generator)
{
	const InternalFunction *const families[] = {
		function_internal_shapes, function_internal_curves, function_internal_algebra, function_internal_blobs,
		function_internal_plane, function_internal_noise,
	};
	for (size_t i = 0; i < sizeof families / sizeof families[0]; i++) {
		const InternalFunction *row = find_in(families[i], number);
		if (row)
			return function_native(arena, 3 + row->parameters, row->eval,
			                       arena_copy(arena, &noise_generator, sizeof noise_generator));
	}
	return NULL;
}
