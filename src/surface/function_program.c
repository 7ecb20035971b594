#include "surface/function_program.h"

#include <math.h>
#include <string.h>

/* A program with more registers would take too much of the stack. */
enum { MAX_REGISTERS = 16384, INLINE_LIMIT = 40, TABLE_SIZE = 1024 };
#define LOOP_LIMIT 1e7

/* An instruction that was made, so that an equal one need not be: chained by hash, newest first. */
typedef struct Made {
	struct Made *next, *older; /* in the chain; in the order of making */
	int at, slot;
	int arg_count;
	const int *args; /* of calls */
} Made;

struct FunctionProgram {
	Arena *scratch;
	Instruction *code;
	int length, capacity;
	int arity, registers;
	bool straight, full;
	Made *newest;
	Made *table[TABLE_SIZE];
};

FunctionProgram *program_begin(Arena *scratch, int arity)
{
	FunctionProgram *program = ARENA_NEW(scratch, FunctionProgram);
	program->scratch = scratch;
	program->arity = program->registers = arity;
	program->straight = true;
	return program;
}

FunctionValue program_argument(int number)
{
	return (FunctionValue){.reg = number};
}

FunctionValue program_constant(double k)
{
	return (FunctionValue){.constant = true, .k = k};
}

FunctionValue program_component(FunctionValue vector, int component)
{
	return (FunctionValue){.reg = vector.reg + component};
}

static int new_registers(FunctionProgram *program, int count)
{
	if (program->registers + count > MAX_REGISTERS) {
		program->full = true;
		return 0;
	}
	program->registers += count;
	return program->registers - count;
}

static int append(FunctionProgram *program, Instruction instruction)
{
	if (program->length == program->capacity) {
		int capacity = program->capacity ? program->capacity * 2 : 32;
		Instruction *code = ARENA_ARRAY(program->scratch, Instruction, capacity);
		if (program->length)
			memcpy(code, program->code, sizeof *code * (size_t)program->length);
		program->code = code;
		program->capacity = capacity;
	}
	program->code[program->length] = instruction;
	return program->length++;
}

/* ---- instructions made before ---- */

static int slot_of(const Instruction *i)
{
	uint64_t k;
	memcpy(&k, &i->k, sizeof k);
	uint64_t hash = (uint64_t)i->op * 31 + i->a;
	hash = (hash * 1021 + i->b) ^ k;
	hash *= 0x9e3779b97f4a7c15u;
	return (int)(hash >> 54);
}

static bool same_instruction(const Instruction *a, const Instruction *b)
{
	return a->op == b->op && a->a == b->a && a->b == b->b &&
	       memcmp(&a->k, &b->k, sizeof a->k) == 0;
}

static void remember(FunctionProgram *program, int slot, int at, const int *args, int arg_count)
{
	Made *made = ARENA_NEW(program->scratch, Made);
	*made = (Made){program->table[slot], program->newest, at, slot, arg_count, args};
	program->table[slot] = program->newest = made;
}

/* What was made from instruction number `from` on may not have run where the program goes on:
 * forget it. */
static void forget_from(FunctionProgram *program, int from)
{
	while (program->newest && program->newest->at >= from) {
		program->table[program->newest->slot] = program->newest->next;
		program->newest = program->newest->older;
	}
}

static FunctionValue make(FunctionProgram *program, Instruction instruction)
{
	int slot = slot_of(&instruction);
	for (const Made *made = program->table[slot]; made; made = made->next)
		if (same_instruction(&program->code[made->at], &instruction))
			return (FunctionValue){.reg = program->code[made->at].to};
	instruction.to = (uint16_t)new_registers(program, 1);
	remember(program, slot, append(program, instruction), NULL, 0);
	return (FunctionValue){.reg = instruction.to};
}

static int register_of(FunctionProgram *program, FunctionValue value)
{
	return value.constant ? make(program, (Instruction){.op = CODE_CONSTANT, .k = value.k}).reg
			      : value.reg;
}

/* ---- operations ---- */

static bool has_one_operand(Opcode op)
{
	return op == CODE_NOT || op == CODE_MOVE || (op >= CODE_NEG && op <= CODE_INT);
}

/* The value of an operation on constants, by running it. */
static double fold(Opcode op, double a, double b)
{
	const Instruction code[] = {{.op = (uint16_t)op, .to = 2, .a = 0, .b = 1},
				    {.op = CODE_RETURN, .a = 2}};
	Function function = {.arity = 2, .code = code, .code_length = 2, .register_count = 3};
	return function_eval(&function, (const double[]){a, b});
}

static FunctionValue unary_with(FunctionProgram *program, Opcode op, FunctionValue a, double k)
{
	return make(program, (Instruction){.op = (uint16_t)op, .a = (uint16_t)a.reg, .k = k});
}

/* Products for powers that scenes use most; false when it is none of them. */
static bool small_power(FunctionProgram *program, FunctionValue a, double exponent,
			FunctionValue *out)
{
	FunctionValue square;
	if (exponent == 1) {
		*out = a;
	} else if (exponent == 2 || exponent == 3 || exponent == 4) {
		square = program_operation(program, CODE_MUL, a, a);
		*out = exponent == 2 ? square
				     : program_operation(program, CODE_MUL, square,
							 exponent == 3 ? a : square);
	} else {
		return false;
	}
	return true;
}

/* a op constant. */
static bool with_right_constant(FunctionProgram *program, Opcode op, FunctionValue a, double k,
				FunctionValue *out)
{
	switch (op) {
	case CODE_ADD: *out = k == 0 ? a : unary_with(program, CODE_ADD_K, a, k); return true;
	case CODE_SUB: *out = k == 0 ? a : unary_with(program, CODE_ADD_K, a, -k); return true;
	case CODE_MUL: *out = k == 1 ? a : unary_with(program, CODE_MUL_K, a, k); return true;
	case CODE_DIV: *out = k == 1 ? a : unary_with(program, CODE_DIV_K, a, k); return true;
	case CODE_POW: return small_power(program, a, k, out);
	default: return false;
	}
}

static bool with_left_constant(FunctionProgram *program, Opcode op, double k, FunctionValue b,
			       FunctionValue *out)
{
	switch (op) {
	case CODE_ADD: *out = k == 0 ? b : unary_with(program, CODE_ADD_K, b, k); return true;
	case CODE_SUB: *out = unary_with(program, CODE_K_SUB, b, k); return true;
	case CODE_MUL: *out = k == 1 ? b : unary_with(program, CODE_MUL_K, b, k); return true;
	case CODE_DIV: *out = unary_with(program, CODE_K_DIV, b, k); return true;
	default: return false;
	}
}

static bool is_commutative(Opcode op)
{
	return op == CODE_ADD || op == CODE_MUL || op == CODE_EQUAL || op == CODE_NOT_EQUAL ||
	       op == CODE_AND || op == CODE_OR;
}

FunctionValue program_operation(FunctionProgram *program, Opcode op, FunctionValue a,
				FunctionValue b)
{
	FunctionValue out;
	if (has_one_operand(op)) {
		if (a.constant)
			return program_constant(fold(op, a.k, 0));
		return make(program, (Instruction){.op = (uint16_t)op, .a = (uint16_t)a.reg});
	}
	if (a.constant && b.constant)
		return program_constant(fold(op, a.k, b.k));
	if (b.constant && with_right_constant(program, op, a, b.k, &out))
		return out;
	if (a.constant && with_left_constant(program, op, a.k, b, &out))
		return out;
	int left = register_of(program, a), right = register_of(program, b);
	if (is_commutative(op) && left > right)
		return make(program, (Instruction){.op = (uint16_t)op,
						   .a = (uint16_t)right,
						   .b = (uint16_t)left});
	return make(program,
		    (Instruction){.op = (uint16_t)op, .a = (uint16_t)left, .b = (uint16_t)right});
}

FunctionValue program_pick(FunctionProgram *program, Opcode op, FunctionValue test,
			   FunctionValue yes, FunctionValue no)
{
	if (test.constant)
		return (op == CODE_PICK_NEGATIVE ? test.k < 0 : test.k == 0) ? yes : no;
	int first = register_of(program, yes), second = register_of(program, no);
	return make(program, (Instruction){.op = (uint16_t)op,
					   .a = (uint16_t)test.reg,
					   .b = (uint16_t)first,
					   .c = (uint32_t)second});
}

/* ---- calls ---- */

/* The first of consecutive registers that hold the arguments: where they are, or copies. */
static int argument_row(FunctionProgram *program, const int *args, int count)
{
	bool in_row = true;
	for (int i = 1; i < count; i++)
		in_row = in_row && args[i] == args[0] + i;
	if (in_row && count > 0)
		return args[0];
	int row = new_registers(program, count);
	for (int i = 0; i < count; i++)
		append(program, (Instruction){.op = CODE_MOVE,
					      .to = (uint16_t)(row + i),
					      .a = (uint16_t)args[i]});
	return row;
}

static FunctionValue make_call(FunctionProgram *program, Instruction call,
			       const FunctionValue *args, int count, int results)
{
	int *regs = ARENA_ARRAY(program->scratch, int, count);
	int slot = slot_of(&call);
	for (int i = 0; i < count; i++)
		regs[i] = register_of(program, args[i]);
	for (const Made *made = program->table[slot]; made; made = made->next) {
		const Instruction *old = &program->code[made->at];
		if (old->op == call.op && old->function == call.function &&
		    made->arg_count == count &&
		    memcmp(made->args, regs, sizeof *regs * (size_t)count) == 0)
			return (FunctionValue){.reg = old->to};
	}
	call.a = (uint16_t)argument_row(program, regs, count);
	call.to = (uint16_t)new_registers(program, results);
	remember(program, slot, append(program, call), regs, count);
	return (FunctionValue){.reg = call.to};
}

/* Replays a short program's instructions with this one's values. */
static FunctionValue take_in(FunctionProgram *program, const Function *function,
			     const FunctionValue *args)
{
	FunctionValue *values = ARENA_ARRAY(program->scratch, FunctionValue,
					    function->register_count);
	for (int i = 0; i < function->arity; i++)
		values[i] = args[i];
	for (const Instruction *i = function->code; i->op != CODE_RETURN; i++) {
		FunctionValue k = program_constant(i->k), a = values[i->a], b = values[i->b];
		switch (i->op) {
		case CODE_CONSTANT: values[i->to] = k; break;
		case CODE_MOVE: values[i->to] = a; break;
		case CODE_ADD_K: values[i->to] = program_operation(program, CODE_ADD, a, k); break;
		case CODE_K_SUB: values[i->to] = program_operation(program, CODE_SUB, k, a); break;
		case CODE_MUL_K: values[i->to] = program_operation(program, CODE_MUL, a, k); break;
		case CODE_DIV_K: values[i->to] = program_operation(program, CODE_DIV, a, k); break;
		case CODE_K_DIV: values[i->to] = program_operation(program, CODE_DIV, k, a); break;
		case CODE_MUL_ADD:
			values[i->to] = program_operation(
				program, CODE_ADD, program_operation(program, CODE_MUL, a, b),
				values[i->c]);
			break;
		case CODE_MUL_SUB:
			values[i->to] = program_operation(
				program, CODE_SUB, program_operation(program, CODE_MUL, a, b),
				values[i->c]);
			break;
		case CODE_PICK_NEGATIVE: case CODE_PICK_ZERO:
			values[i->to] = program_pick(program, (Opcode)i->op, a, b, values[i->c]);
			break;
		case CODE_NATIVE:
		case CODE_CALL:
			values[i->to] = program_call(program, i->function, &values[i->a]);
			break;
		case CODE_VECTOR_CALL: {
			FunctionValue row = program_vector_call(program, i->vector, &values[i->a]);
			for (int c = 0; c < 5; c++)
				values[i->to + c] = program_component(row, c);
			break;
		}
		default: values[i->to] = program_operation(program, (Opcode)i->op, a, b); break;
		}
	}
	return values[function->code[function->code_length - 1].a];
}

FunctionValue program_call(FunctionProgram *program, const Function *function,
			   const FunctionValue *args)
{
	if (!function->native && function->straight && function->code_length <= INLINE_LIMIT)
		return take_in(program, function, args);
	Instruction call = {.op = function->native ? CODE_NATIVE : CODE_CALL, .function = function};
	return make_call(program, call, args, function->arity, 1);
}

FunctionValue program_vector_call(FunctionProgram *program, const VectorFunction *vector,
				  const FunctionValue *args)
{
	Instruction call = {.op = CODE_VECTOR_CALL, .vector = vector};
	return make_call(program, call, args, vector->arity, 5);
}

/* ---- branches and loops ---- */

static void jump_here(FunctionProgram *program, int jump)
{
	program->code[jump].target = (uint32_t)(program->length - jump);
}

static void copy_to(FunctionProgram *program, int to, FunctionValue value)
{
	if (value.constant)
		append(program,
		       (Instruction){.op = CODE_CONSTANT, .to = (uint16_t)to, .k = value.k});
	else
		append(program, (Instruction){.op = CODE_MOVE,
					      .to = (uint16_t)to,
					      .a = (uint16_t)value.reg});
}

FunctionBranch program_if(FunctionProgram *program, Opcode op, FunctionValue test)
{
	FunctionBranch branch = {.result = new_registers(program, 1)};
	program->straight = false;
	branch.jump = append(program, (Instruction){.op = (uint16_t)op,
						    .a = (uint16_t)register_of(program, test)});
	branch.scope = program->length;
	return branch;
}

void program_else(FunctionProgram *program, FunctionBranch *branch, FunctionValue first)
{
	copy_to(program, branch->result, first);
	branch->end = append(program, (Instruction){.op = CODE_JUMP});
	forget_from(program, branch->scope);
	jump_here(program, branch->jump);
}

FunctionValue program_end_if(FunctionProgram *program, FunctionBranch *branch, FunctionValue second)
{
	copy_to(program, branch->result, second);
	forget_from(program, branch->scope);
	jump_here(program, branch->end);
	return (FunctionValue){.reg = branch->result};
}

FunctionLoop program_loop(FunctionProgram *program, FunctionValue from, FunctionValue to,
			  bool product)
{
	FunctionLoop loop = {.product = product, .total = new_registers(program, 1)};
	FunctionValue limit = program_operation(program, CODE_ADD, from,
						program_constant(LOOP_LIMIT));
	int last = register_of(program, program_operation(program, CODE_MIN, to, limit));
	loop.variable = (FunctionValue){.reg = new_registers(program, 1)};
	program->straight = false;
	copy_to(program, loop.total, program_constant(product));
	copy_to(program, loop.variable.reg, from);
	loop.top = append(program, (Instruction){.op = CODE_JUMP_BEYOND,
						 .a = (uint16_t)loop.variable.reg,
						 .b = (uint16_t)last});
	loop.scope = program->length;
	return loop;
}

FunctionValue program_end_loop(FunctionProgram *program, FunctionLoop *loop, FunctionValue body)
{
	uint16_t total = (uint16_t)loop->total, variable = (uint16_t)loop->variable.reg;
	uint16_t part = (uint16_t)register_of(program, body);
	append(program, (Instruction){.op = loop->product ? CODE_MUL : CODE_ADD,
				      .to = total,
				      .a = total,
				      .b = part});
	append(program, (Instruction){.op = CODE_ADD_K, .to = variable, .a = variable, .k = 1});
	int back = append(program, (Instruction){.op = CODE_JUMP});
	program->code[back].target = (uint32_t)(loop->top - back);
	forget_from(program, loop->scope);
	jump_here(program, loop->top);
	return (FunctionValue){.reg = loop->total};
}

/* ---- the finished program ---- */

static void count_use(int *uses, const Instruction *i, int arity_of_call)
{
	if (i->op == CODE_CONSTANT || i->op == CODE_JUMP)
		return;
	for (int n = 0; n < (arity_of_call ? arity_of_call : 1); n++)
		uses[i->a + n]++;
	if (!arity_of_call && !has_one_operand((Opcode)i->op))
		uses[i->b]++;
	if (i->op == CODE_PICK_NEGATIVE || i->op == CODE_PICK_ZERO)
		uses[i->c]++;
}

static int arity_of(const Instruction *i)
{
	if (i->op == CODE_VECTOR_CALL)
		return i->vector->arity;
	return i->op == CODE_NATIVE || i->op == CODE_CALL ? i->function->arity : 0;
}

/* Turns a product that only the next instruction adds into one MUL_ADD (MUL_SUB); the product
 * becomes a JUMP to be removed. A jump target between the two would be fine: nothing else reads the
 * product. */
static void fuse_products(FunctionProgram *program, const int *uses)
{
	for (int n = 1; n < program->length; n++) {
		Instruction *i = &program->code[n], *product = &program->code[n - 1];
		bool left = i->a == product->to,
		     usable = product->op == CODE_MUL && uses[product->to] == 1 && i->a != i->b;
		bool adds = i->op == CODE_ADD && (left || i->b == product->to) && i->to != i->a &&
			    i->to != i->b;
		bool subtracts = i->op == CODE_SUB && left;
		if (!usable || (!adds && !subtracts))
			continue;
		*product = (Instruction){.op = adds ? CODE_MUL_ADD : CODE_MUL_SUB,
					 .to = i->to,
					 .a = product->a,
					 .b = product->b,
					 .c = left ? i->b : i->a};
		*i = (Instruction){.op = CODE_JUMP, .target = 1};
	}
}

static bool is_jump(const Instruction *i)
{
	return i->op >= CODE_JUMP && i->op <= CODE_JUMP_BEYOND;
}

/* Leaves out jumps to the next instruction and sets the others' targets anew. */
static int compact(Arena *scratch, const Instruction *code, int length, Instruction *out)
{
	int *place = ARENA_ARRAY(scratch, int, length + 1), count = 0;
	for (int n = 0; n < length; n++) {
		place[n] = count;
		if (code[n].op != CODE_JUMP || code[n].target != 1)
			out[count++] = code[n];
	}
	place[length] = count;
	for (int n = 0; n < length; n++)
		if (is_jump(&code[n]) && (code[n].op != CODE_JUMP || code[n].target != 1))
			out[place[n]].target = (uint32_t)(place[n + (int32_t)code[n].target] -
							  place[n]);
	return count;
}

const Function *program_finish(FunctionProgram *program, Arena *arena, FunctionValue result)
{
	append(program,
	       (Instruction){.op = CODE_RETURN, .a = (uint16_t)register_of(program, result)});
	if (program->full)
		return NULL;
	int *uses = ARENA_ARRAY(program->scratch, int, program->registers + FUNCTION_MAX_ARGUMENTS);
	for (int n = 0; n < program->length; n++)
		count_use(uses, &program->code[n], arity_of(&program->code[n]));
	fuse_products(program, uses);
	Instruction *code = ARENA_ARRAY(arena, Instruction, program->length);
	Function *function = ARENA_NEW(arena, Function);
	*function = (Function){.arity = program->arity,
			       .code = code,
			       .register_count = program->registers + 1,
			       .straight = program->straight};
	function->code_length = compact(program->scratch, program->code, program->length, code);
	return function;
}
