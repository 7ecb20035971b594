#include "lang/builtin.h"

#include <limits.h>
#include <stdint.h>

static Value domain_error(const BuiltinCall *call, double x)
{
	diag_error(call->context->diag, call->where, "'%s' of %g is not defined",
		   word_text(call->word), x);
	return value_float(0);
}

/* POV-Ray's integers are 32 bits wide; what does not fit gives the least one. */
double builtin_int(double x)
{
	return fabs(x) < 2147483648.0 ? trunc(x) + 0.0 : (double)INT_MIN;
}

double builtin_div(double a, double b)
{
	return builtin_int(a / b);
}

double builtin_degrees(double radians)
{
	return radians * 180 / M_PI;
}

double builtin_radians(double degrees)
{
	return degrees * M_PI / 180;
}

double builtin_sqr(double x)
{
	return x * x;
}

/* Outside [-1, 1]: a warning and the nearest end's value, as POV-Ray does. */
static double clamped(const BuiltinCall *call)
{
	double x = call->args[0].number;
	if (fabs(x) <= 1)
		return x;
	diag_warning(call->context->diag, call->where,
		     "'%s' of %g is not defined: the argument is clamped", word_text(call->word),
		     x);
	return x > 0 ? 1 : -1;
}

Value builtin_asin(const BuiltinCall *call)
{
	return value_float(asin(clamped(call)));
}

Value builtin_acos(const BuiltinCall *call)
{
	return value_float(acos(clamped(call)));
}

Value builtin_sqrt(const BuiltinCall *call)
{
	double x = call->args[0].number;
	return x < 0 ? domain_error(call, x) : value_float(sqrt(x));
}

Value builtin_logarithm(const BuiltinCall *call)
{
	double x = call->args[0].number;
	if (x <= 0)
		return domain_error(call, x);
	return value_float(call->word == W_ln ? log(x) : log10(x));
}

Value builtin_pow(const BuiltinCall *call)
{
	double x = call->args[0].number, y = call->args[1].number;
	return x == 0 && y == 0 ? domain_error(call, x) : value_float(pow(x, y));
}

Value builtin_atan2(const BuiltinCall *call)
{
	double y = call->args[0].number, x = call->args[1].number;
	if (!expression_is_true(x) && !expression_is_true(y))
		return domain_error(call, y);
	return value_float(atan2(y, x));
}

Value builtin_extreme(const BuiltinCall *call)
{
	double best = call->args[0].number;
	for (int i = 1; i < call->count; i++) {
		double x = call->args[i].number;
		if (call->word == W_min ? x < best : x > best)
			best = x;
	}
	return value_float(best);
}

Value builtin_bitwise(const BuiltinCall *call)
{
	int bits = (int)builtin_int(call->args[0].number);
	for (int i = 1; i < call->count; i++) {
		int x = (int)builtin_int(call->args[i].number);
		bits = call->word == W_bitwise_and  ? bits & x
		       : call->word == W_bitwise_or ? bits | x
						    : bits ^ x;
	}
	return value_float(bits);
}

/* select(a, below, zero, above) or select(a, below, otherwise); zero is exact. */
Value builtin_select(const BuiltinCall *call)
{
	double a = call->args[0].number;
	int pick = a < 0 ? 1 : a == 0 ? 2 : 3;
	return call->args[pick < call->count ? pick : call->count - 1];
}

/* The streams that seed() has started: their number is the value, as in POV-Ray. */
struct RandomStreams {
	uint32_t *states;
	int count, capacity;
};

static struct RandomStreams *streams_of(Context *context)
{
	if (!context->random)
		context->random = ARENA_NEW(context->parse, struct RandomStreams);
	return context->random;
}

Value builtin_seed(const BuiltinCall *call)
{
	struct RandomStreams *streams = streams_of(call->context);
	if (streams->count == streams->capacity) {
		int capacity = streams->capacity ? streams->capacity * 2 : 16;
		uint32_t *states = ARENA_ARRAY(call->context->parse, uint32_t, capacity);
		for (int i = 0; i < streams->count; i++)
			states[i] = streams->states[i];
		streams->states = states;
		streams->capacity = capacity;
	}
	streams->states[streams->count] = (uint32_t)(int)builtin_int(call->args[0].number);
	return value_float(streams->count++);
}

/* The linear congruential generator whose numbers POV-Ray's scenes know: 32 bits, both ends of [0,
 * 1] included. */
Value builtin_rand(const BuiltinCall *call)
{
	struct RandomStreams *streams = streams_of(call->context);
	int number = (int)builtin_int(call->args[0].number);
	if (number < 0 || number >= streams->count) {
		diag_error(call->context->diag, call->where,
			   "no random stream %d: 'rand' takes what 'seed' gave", number);
		return value_float(0);
	}
	uint32_t next = streams->states[number] * 1812433253u + 12345u;
	streams->states[number] = next;
	return value_float(next / 4294967295.0);
}
