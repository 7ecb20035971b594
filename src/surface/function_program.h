/*
 * Builds the program of a user function, value by value. A FunctionValue stands for a constant or
 * for what an instruction computes; asking twice for the same computation gives the same value,
 * constants fold, powers with small exponents become products, short functions are taken in where
 * they are called.
 *
 * Values made inside a branch or a loop are forgotten at its end, except its result.
 */
#ifndef SURFACE_FUNCTION_PROGRAM_H
#define SURFACE_FUNCTION_PROGRAM_H

#include "surface/function_code.h"

typedef struct FunctionProgram FunctionProgram;

typedef struct FunctionValue {
	bool constant;
	int reg;
	double k;
} FunctionValue;

/* scratch holds the draft; only what program_finish gives is kept elsewhere. */
FunctionProgram *program_begin(Arena *scratch, int arity);
FunctionValue program_argument(int number);
FunctionValue program_constant(double k);
/* An operation of one or two operands (MUL_ADD and the like come by themselves; b is ignored by
 * those of one). */
FunctionValue program_operation(FunctionProgram *program, Opcode op, FunctionValue a,
				FunctionValue b);
/* PICK_NEGATIVE: yes where test < 0; PICK_ZERO: yes where test == 0; both ways are computed. */
FunctionValue program_pick(FunctionProgram *program, Opcode op, FunctionValue test,
			   FunctionValue yes, FunctionValue no);
FunctionValue program_call(FunctionProgram *program, const Function *function,
			   const FunctionValue *args);
/* The five results are the value and those of the registers after it. */
FunctionValue program_vector_call(FunctionProgram *program, const VectorFunction *vector,
				  const FunctionValue *args);
FunctionValue program_component(FunctionValue vector, int component);

/* Computes one of two ways: program_if ... (first way) program_else ... (second way)
 * program_end_if. op is JUMP_NOT_NEGATIVE (first way when test < 0) or JUMP_NOT_ZERO (when test ==
 * 0). */
typedef struct FunctionBranch {
	int jump, end, scope, result;
} FunctionBranch;
FunctionBranch program_if(FunctionProgram *program, Opcode op, FunctionValue test);
void program_else(FunctionProgram *program, FunctionBranch *branch, FunctionValue first);
FunctionValue program_end_if(FunctionProgram *program, FunctionBranch *branch,
			     FunctionValue second);

/* Sum or product of a body over variable = from, from + 1, ... while it is at most to (10 million
 * steps at most). */
typedef struct FunctionLoop {
	FunctionValue variable;
	int total, top, jump, scope;
	bool product;
} FunctionLoop;
FunctionLoop program_loop(FunctionProgram *program, FunctionValue from, FunctionValue to,
			  bool product);
FunctionValue program_end_loop(FunctionProgram *program, FunctionLoop *loop, FunctionValue body);

/* NULL when the program got too long. */
const Function *program_finish(FunctionProgram *program, Arena *arena, FunctionValue result);

#endif
