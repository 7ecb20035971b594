#include "surface/function_internal.h"

#include "surface/function_code.h"
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

static const Function *make_function(Arena *arena, const InternalFunction *row, int noise_generator)
{
	Function *function = ARENA_NEW(arena, Function);
	*function = (Function){.arity = 3 + row->parameters,
			       .native = row->eval,
			       .approximate = row->approximate,
			       .data = arena_copy(arena, &noise_generator, sizeof noise_generator)};
	return function;
}

const Function *function_internal_find(Arena *arena, int number, int noise_generator)
{
	const InternalFunction *const families[] = {
		function_internal_shapes, function_internal_curves, function_internal_algebra,
		function_internal_blobs,  function_internal_plane,  function_internal_noise,
	};
	for (size_t i = 0; i < sizeof families / sizeof families[0]; i++) {
		const InternalFunction *row = find_in(families[i], number);
		if (row)
			return make_function(arena, row, noise_generator);
	}
	return NULL;
}
