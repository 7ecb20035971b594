/*
 * The code of user functions, shared by the builder (function_program.c) and the machine
 * (function.c).
 *
 * An instruction is 16 bytes: operation, target register, two operand registers, and an immediate:
 * a constant, a third register, a jump target or what is called. Registers are doubles; the first
 * ones are the arguments. Every register is written in one place only, loops excepted, so that
 * equal instructions have equal results.
 */
#ifndef SURFACE_FUNCTION_CODE_H
#define SURFACE_FUNCTION_CODE_H

#include <stdint.h>

#include "surface/function.h"

/* OPCODE(name): `k` is the constant, `c` the third register. */
#define FUNCTION_OPCODES(OPCODE)                                                                   \
	OPCODE(CONSTANT)                                                                           \
	OPCODE(MOVE) OPCODE(ADD) OPCODE(SUB) OPCODE(MUL) OPCODE(DIV) OPCODE(MUL_ADD) OPCODE(       \
		MUL_SUB) OPCODE(ADD_K) OPCODE(K_SUB) OPCODE(MUL_K) OPCODE(DIV_K) OPCODE(K_DIV)     \
		OPCODE(LESS) OPCODE(LESS_EQUAL) OPCODE(EQUAL) OPCODE(NOT_EQUAL) OPCODE(            \
			AND) OPCODE(OR) OPCODE(NOT) OPCODE(MIN) OPCODE(MAX) OPCODE(MOD)            \
			OPCODE(POW) OPCODE(ATAN2) OPCODE(INT_DIV) OPCODE(NEG) OPCODE(ABS) OPCODE(  \
				SQRT) OPCODE(EXP) OPCODE(LN) OPCODE(LOG10) OPCODE(SIN) OPCODE(COS) \
				OPCODE(TAN) OPCODE(ASIN) OPCODE(ACOS) OPCODE(ATAN) OPCODE(         \
					SINH) OPCODE(COSH) OPCODE(TANH) OPCODE(ASINH)              \
					OPCODE(ACOSH) OPCODE(ATANH) OPCODE(FLOOR) OPCODE(          \
						CEIL) OPCODE(INT)                                  \
						OPCODE(PICK_NEGATIVE) /* a < 0 ? b : c */ OPCODE(  \
							PICK_ZERO) /* a == 0 ? b : c */            \
		OPCODE(JUMP) OPCODE(JUMP_NOT_NEGATIVE) OPCODE(JUMP_NOT_ZERO)                       \
			OPCODE(JUMP_BEYOND) /* unless a <= b */                                    \
		OPCODE(NATIVE) OPCODE(CALL) OPCODE(VECTOR_CALL) /* arguments from register a on */ \
		OPCODE(RETURN)

typedef enum Opcode {
#define OPCODE(name) CODE_##name,
	FUNCTION_OPCODES(OPCODE)
#undef OPCODE
	CODE_COUNT
} Opcode;

typedef struct Instruction {
	uint16_t op, to, a, b;
	union {
		double k;
		uint32_t c;
		uint32_t target;
		const Function *function;
		const VectorFunction
			*vector; /* its five results go to `to` and the registers after it */
	};
} Instruction;

struct Function {
	int arity;
	FunctionNative *native; /* NULL: a program */
	const void *data;
	const Instruction *code;
	int code_length, register_count;
	bool approximate; /* an internal function that is not quite POV-Ray's */
	bool straight; /* no jumps: can be taken into other programs */
};

/* int(): towards zero, 32 bits; what does not fit gives the least one. */
double function_int(double x);

#endif
