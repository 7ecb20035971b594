/* The register machine and the builder of its programs. */
#include "surface/function_program.h"

#include "check.h"

static Arena *arena;

static FunctionValue operate(FunctionProgram *program, Opcode op, FunctionValue a, FunctionValue b)
{
	return program_operation(program, op, a, b);
}

static void test_arithmetic(void)
{
	FunctionProgram *p = program_begin(arena, 3);
	FunctionValue x = program_argument(0), y = program_argument(1), z = program_argument(2);
	FunctionValue sum = operate(p, CODE_ADD, operate(p, CODE_MUL, x, y), z);
	const Function *f = program_finish(p, arena,
					   operate(p, CODE_POW, sum, program_constant(2)));
	CHECK_NEAR(function_eval(f, (const double[]){2, 3, 4}), 100, 1e-12);
	CHECK(f->straight && function_arity(f) == 3);
}

/* Constants fold, and the same computation is made once. */
static void test_folding(void)
{
	FunctionProgram *p = program_begin(arena, 1);
	FunctionValue x = program_argument(0);
	FunctionValue k = operate(p, CODE_SIN, program_constant(0.5), program_constant(0));
	CHECK(k.constant);
	CHECK_NEAR(k.k, sin(0.5), 1e-15);
	FunctionValue a = operate(p, CODE_SIN, x, x), b = operate(p, CODE_SIN, x, x);
	CHECK(a.reg == b.reg);
	CHECK(operate(p, CODE_ADD, a, x).reg == operate(p, CODE_ADD, x, a).reg);
	const Function *f = program_finish(p, arena, a);
	CHECK(f->code_length <= 3);
}

/* x < 0 ? sin(x) : x == 0 ? 5 : sqrt(x), by jumps. */
static void test_branch(void)
{
	FunctionProgram *p = program_begin(arena, 1);
	FunctionValue x = program_argument(0);
	FunctionBranch branch = program_if(p, CODE_JUMP_NOT_NEGATIVE, x);
	program_else(p, &branch, operate(p, CODE_SIN, x, x));
	FunctionValue other = program_pick(p, CODE_PICK_ZERO, x, program_constant(5),
					   operate(p, CODE_SQRT, x, x));
	const Function *f = program_finish(p, arena, program_end_if(p, &branch, other));
	CHECK_NEAR(function_eval(f, (const double[]){-1}), sin(-1), 1e-15);
	CHECK_NEAR(function_eval(f, (const double[]){0}), 5, 0);
	CHECK_NEAR(function_eval(f, (const double[]){9}), 3, 0);
}

static const Function *sum_of_squares(void)
{
	FunctionProgram *p = program_begin(arena, 1);
	FunctionLoop loop = program_loop(p, program_constant(1), program_argument(0), false);
	FunctionValue square = operate(p, CODE_MUL, loop.variable, loop.variable);
	return program_finish(p, arena, program_end_loop(p, &loop, square));
}

static void test_loop(void)
{
	const Function *f = sum_of_squares();
	CHECK_NEAR(function_eval(f, (const double[]){4.5}), 30, 0);
	CHECK_NEAR(function_eval(f, (const double[]){0}), 0, 0);
	CHECK_NEAR(function_eval(f, (const double[]){NAN}), 0, 0);
}

/* A short function is taken in where it is called; one with a loop is called. */
static void test_calls(void)
{
	FunctionProgram *p = program_begin(arena, 2);
	FunctionValue args[2] = {program_argument(0), program_argument(1)};
	const Function *difference = program_finish(p, arena,
						    operate(p, CODE_SUB, args[0], args[1]));
	p = program_begin(arena, 2);
	FunctionValue swapped[2] = {program_argument(1), program_argument(0)};
	FunctionValue value = program_call(p, difference, swapped);
	FunctionValue squares = program_call(p, sum_of_squares(), &value);
	const Function *f = program_finish(p, arena, operate(p, CODE_ADD, value, squares));
	CHECK_NEAR(function_eval(f, (const double[]){1, 4}), 3 + 14, 0);
}

static void swap_two(const void *data, const double *args, double out[5])
{
	(void)data;
	out[0] = args[1];
	out[1] = args[0];
	out[2] = out[3] = out[4] = 0;
}

static void test_vector(void)
{
	const VectorFunction swap = {2, 2, false, swap_two, NULL};
	FunctionProgram *p = program_begin(arena, 2);
	FunctionValue args[2] = {program_argument(0), program_argument(1)};
	FunctionValue row = program_vector_call(p, &swap, args);
	CHECK(program_vector_call(p, &swap, args).reg == row.reg);
	FunctionValue value = operate(p, CODE_SUB, program_component(row, 0),
				      program_component(row, 1));
	const Function *f = program_finish(p, arena, value);
	CHECK_NEAR(function_eval(f, (const double[]){2, 7}), 5, 0);
}

int main(void)
{
	arena = arena_create();
	test_arithmetic();
	test_folding();
	test_branch();
	test_loop();
	test_calls();
	test_vector();
	arena_destroy(arena);
	return CHECK_RESULT();
}
