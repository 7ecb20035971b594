/*
 * The machine that runs user functions: threaded code, one indirect jump an instruction. Registers
 * live on the caller's stack. Comparisons are exact here, unlike those of the parser, as in
 * POV-Ray.
 */
#include "surface/function.h"

#include <math.h>
#include <string.h>

#include "surface/function_code.h"

double function_int(double x)
{
	return fabs(x) < 2147483648.0 ? trunc(x) + 0.0 : -2147483648.0;
}

int function_arity(const Function *function)
{
	return function->arity;
}

bool function_is_approximate(const Function *function)
{
	return function->approximate;
}

const Function *function_native(Arena *arena, int arity, FunctionNative *native, const void *data)
{
	Function *function = ARENA_NEW(arena, Function);
	*function = (Function){.arity = arity, .native = native, .data = data};
	return function;
}

#define A (r[i->a])
#define B (r[i->b])
#define C (r[i->c])
#define NEXT() do { i++; goto *labels[i->op]; } while (0)
#define SET(name, value) run_##name: r[i->to] = (value); NEXT();

static double run_program(const Instruction *i, double *r)
{
	static const void *const labels[CODE_COUNT] = {
#define OPCODE(name) [CODE_##name] = &&run_##name,
		FUNCTION_OPCODES(OPCODE)
#undef OPCODE
	};
	goto *labels[i->op];
	SET(CONSTANT, i->k)
	SET(MOVE, A)
	SET(ADD, A + B)
	SET(SUB, A - B)
	SET(MUL, A * B)
	SET(DIV, A / B)
	SET(MUL_ADD, A * B + C)
	SET(MUL_SUB, A * B - C)
	SET(ADD_K, A + i->k)
	SET(K_SUB, i->k - A)
	SET(MUL_K, A * i->k)
	SET(DIV_K, A / i->k)
	SET(K_DIV, i->k / A)
	SET(LESS, A < B)
	SET(LESS_EQUAL, A <= B)
	SET(EQUAL, A == B)
	SET(NOT_EQUAL, A != B)
	SET(AND, A != 0 && B != 0)
	SET(OR, A != 0 || B != 0)
	SET(NOT, A == 0)
	SET(MIN, B < A ? B : A)
	SET(MAX, B > A ? B : A)
	SET(MOD, fmod(A, B))
	SET(POW, pow(A, B))
	SET(ATAN2, atan2(A, B))
	SET(INT_DIV, function_int(A / B))
	SET(NEG, -A)
	SET(ABS, fabs(A))
	SET(SQRT, sqrt(A))
	SET(EXP, exp(A))
	SET(LN, log(A))
	SET(LOG10, log10(A))
	SET(SIN, sin(A))
	SET(COS, cos(A))
	SET(TAN, tan(A))
	SET(ASIN, asin(A))
	SET(ACOS, acos(A))
	SET(ATAN, atan(A))
	SET(SINH, sinh(A))
	SET(COSH, cosh(A))
	SET(TANH, tanh(A))
	SET(ASINH, asinh(A))
	SET(ACOSH, acosh(A))
	SET(ATANH, atanh(A))
	SET(FLOOR, floor(A))
	SET(CEIL, ceil(A))
	SET(INT, function_int(A))
	SET(PICK_NEGATIVE, A < 0 ? B : C)
	SET(PICK_ZERO, A == 0 ? B : C)
	SET(NATIVE, i->function->native(i->function->data, &A))
	SET(CALL, function_eval(i->function, &A))
run_VECTOR_CALL:
	i->vector->eval(i->vector->data, &A, &r[i->to]);
	NEXT();
run_JUMP:
	i += (int32_t)i->target;
	goto *labels[i->op];
run_JUMP_NOT_NEGATIVE:
	i += A < 0 ? 1 : (int32_t)i->target;
	goto *labels[i->op];
run_JUMP_NOT_ZERO:
	i += A == 0 ? 1 : (int32_t)i->target;
	goto *labels[i->op];
run_JUMP_BEYOND:
	i += A <= B ? 1 : (int32_t)i->target;
	goto *labels[i->op];
run_RETURN:
	return A;
}

double function_eval(const Function *function, const double *args)
{
	if (function->native)
		return function->native(function->data, args);
	double registers[function->register_count];
	for (int i = 0; i < function->arity; i++)
		registers[i] = args[i];
	return run_program(function->code, registers);
}
