#include "lang/function_compile.h"

#include "surface/function_program.h"

/* Arguments and the variables of sums by number. */
typedef struct Compiler {
	FunctionProgram *program;
	Arena *scratch;
	FunctionValue variables[FUNCTION_MAX_ARGUMENTS];
} Compiler;

/* Ways of a select() that cost no more than this together are both computed: a jump costs as much.
 */
enum { PICK_LIMIT = 6 };

static FunctionValue compile(Compiler *compiler, const Expression *e);

/* The operations a tree takes at run time, roughly; calls count much. */
static int tree_cost(const Expression *e)
{
	int cost = e->kind == EXPRESSION_BINARY || e->kind == EXPRESSION_UNARY ? 1 :
	           e->kind == EXPRESSION_CONSTANT || e->kind == EXPRESSION_ARGUMENT ? 0 : 20;
	for (int i = 0; i < e->part_count && cost <= PICK_LIMIT; i++)
		cost += tree_cost(e->parts[i]);
	return cost;
}

static FunctionValue compile_unary(Compiler *compiler, const Expression *e)
{
	FunctionValue a = compile(compiler, e->parts[0]);
	return program_operation(compiler->program, e->op == OP_NOT ? CODE_NOT : CODE_NEG, a, a);
}

static FunctionValue compile_binary(Compiler *compiler, const Expression *e)
{
	static const Opcode codes[] = {
		[OP_ADD] = CODE_ADD,
		[OP_SUB] = CODE_SUB,
		[OP_MUL] = CODE_MUL,
		[OP_DIV] = CODE_DIV,
		[OP_LESS] = CODE_LESS,
		[OP_LESS_EQUAL] = CODE_LESS_EQUAL,
		[OP_EQUAL] = CODE_EQUAL,
		[OP_NOT_EQUAL] = CODE_NOT_EQUAL,
		[OP_GREATER_EQUAL] = CODE_LESS_EQUAL,
		[OP_GREATER] = CODE_LESS,
		[OP_AND] = CODE_AND,
		[OP_OR] = CODE_OR,
	};
	FunctionValue a = compile(compiler, e->parts[0]), b = compile(compiler, e->parts[1]);
	bool swapped = e->op == OP_GREATER_EQUAL || e->op == OP_GREATER;
	return program_operation(compiler->program, codes[e->op], swapped ? b : a, swapped ? a : b);
}

static FunctionValue compile_branch(Compiler *compiler, Opcode op, FunctionValue test,
				    const Expression *const ways[2])
{
	FunctionBranch branch = program_if(compiler->program, op, test);
	program_else(compiler->program, &branch, compile(compiler, ways[0]));
	return program_end_if(compiler->program, &branch, compile(compiler, ways[1]));
}

/* ways[0] where test < 0 (or == 0), else ways[1]. */
static FunctionValue compile_choice(Compiler *compiler, bool zero, FunctionValue test,
				    const Expression *const ways[2])
{
	if (test.constant)
		return compile(compiler, ways[(zero ? test.k == 0 : test.k < 0) ? 0 : 1]);
	if (tree_cost(ways[0]) + tree_cost(ways[1]) > PICK_LIMIT)
		return compile_branch(compiler, zero ? CODE_JUMP_NOT_ZERO : CODE_JUMP_NOT_NEGATIVE,
				      test, ways);
	FunctionValue yes = compile(compiler, ways[0]), no = compile(compiler, ways[1]);
	return program_pick(compiler->program, zero ? CODE_PICK_ZERO : CODE_PICK_NEGATIVE, test,
			    yes, no);
}

/* The last two of select's four arguments depend on whether the first is 0: a choice within a
 * choice. */
static FunctionValue compile_select(Compiler *compiler, const Expression *e)
{
	FunctionValue test = compile(compiler, e->parts[0]);
	if (e->part_count == 3)
		return compile_choice(compiler, false, test, &e->parts[1]);
	if (test.constant)
		return compile(compiler, e->parts[test.k < 0 ? 1 : test.k == 0 ? 2 : 3]);
	FunctionBranch branch = program_if(compiler->program, CODE_JUMP_NOT_NEGATIVE, test);
	program_else(compiler->program, &branch, compile(compiler, e->parts[1]));
	FunctionValue other = compile_choice(compiler, true, test, &e->parts[2]);
	return program_end_if(compiler->program, &branch, other);
}

static FunctionValue compile_conditional(Compiler *compiler, const Expression *e)
{
	const Expression *ways[2] = {e->parts[2], e->parts[1]};
	return compile_choice(compiler, true, compile(compiler, e->parts[0]), ways);
}

static Opcode opcode_of(Word word)
{
	switch (word) {
	case W_abs: return CODE_ABS;
	case W_acos: return CODE_ACOS;
	case W_acosh: return CODE_ACOSH;
	case W_asin: return CODE_ASIN;
	case W_asinh: return CODE_ASINH;
	case W_atan: return CODE_ATAN;
	case W_atan2: return CODE_ATAN2;
	case W_atanh: return CODE_ATANH;
	case W_ceil: return CODE_CEIL;
	case W_cos: return CODE_COS;
	case W_cosh: return CODE_COSH;
	case W_div: return CODE_INT_DIV;
	case W_exp: return CODE_EXP;
	case W_floor: return CODE_FLOOR;
	case W_int: return CODE_INT;
	case W_ln: return CODE_LN;
	case W_log: return CODE_LOG10;
	case W_max: return CODE_MAX;
	case W_min: return CODE_MIN;
	case W_mod: return CODE_MOD;
	case W_pow: return CODE_POW;
	case W_sin: return CODE_SIN;
	case W_sinh: return CODE_SINH;
	case W_sqr: return CODE_MUL;
	case W_sqrt: return CODE_SQRT;
	case W_tan: return CODE_TAN;
	default: return CODE_TANH;
	}
}

static FunctionValue compile_call(Compiler *compiler, const Expression *e)
{
	FunctionProgram *program = compiler->program;
	if (e->word == W_select)
		return compile_select(compiler, e);
	FunctionValue a = compile(compiler, e->parts[0]);
	if (e->word == W_degrees)
		return program_operation(program, CODE_MUL, a, program_constant(180 / M_PI));
	if (e->word == W_radians)
		return program_operation(program, CODE_MUL, a, program_constant(M_PI / 180));
	if (e->part_count == 1 && (e->word == W_min || e->word == W_max))
		return a;
	if (e->part_count == 1)
		return program_operation(program, opcode_of(e->word), a, a);
	for (int i = 1; i < e->part_count; i++)
		a = program_operation(program, opcode_of(e->word), a,
				      compile(compiler, e->parts[i]));
	return a;
}

static const FunctionValue *compile_parts(Compiler *compiler, const Expression *e)
{
	FunctionValue *values = ARENA_ARRAY(compiler->scratch, FunctionValue, e->part_count);
	for (int i = 0; i < e->part_count; i++)
		values[i] = compile(compiler, e->parts[i]);
	return values;
}

static FunctionValue compile_component(Compiler *compiler, const Expression *e)
{
	FunctionProgram *program = compiler->program;
	const Expression *vector = e->parts[0];
	FunctionValue row = program_vector_call(program, vector->callee.item,
						compile_parts(compiler, vector));
	if (e->number < 5)
		return program_component(row, e->number);
	const double weights[3] = {0.297, 0.589, 0.114};
	FunctionValue gray = program_constant(0);
	for (int c = 0; c < 3; c++) {
		FunctionValue part = program_operation(program, CODE_MUL, program_component(row, c),
						       program_constant(weights[c]));
		gray = program_operation(program, CODE_ADD, gray, part);
	}
	return gray;
}

static FunctionValue compile_loop(Compiler *compiler, const Expression *e)
{
	FunctionValue from = compile(compiler, e->parts[0]), to = compile(compiler, e->parts[1]);
	FunctionLoop loop = program_loop(compiler->program, from, to, e->word == W_prod);
	FunctionValue outer = compiler->variables[e->number];
	compiler->variables[e->number] = loop.variable;
	FunctionValue body = compile(compiler, e->parts[2]);
	compiler->variables[e->number] = outer;
	return program_end_loop(compiler->program, &loop, body);
}

static FunctionValue compile(Compiler *compiler, const Expression *e)
{
	switch (e->kind) {
	case EXPRESSION_CONSTANT: return program_constant(e->constant);
	case EXPRESSION_ARGUMENT: return compiler->variables[e->number];
	case EXPRESSION_UNARY: return compile_unary(compiler, e);
	case EXPRESSION_BINARY: return compile_binary(compiler, e);
	case EXPRESSION_CONDITIONAL: return compile_conditional(compiler, e);
	case EXPRESSION_CALL: return compile_call(compiler, e);
	case EXPRESSION_FUNCTION:
		return program_call(compiler->program, e->callee.item, compile_parts(compiler, e));
	case EXPRESSION_COMPONENT: return compile_component(compiler, e);
	case EXPRESSION_LOOP: return compile_loop(compiler, e);
	default: return program_constant(0);
	}
}

const Function *function_compile(const Expression *body, int arity, Arena *scratch, Arena *arena)
{
	ArenaMark mark = arena_mark(scratch);
	Compiler compiler = {.program = program_begin(scratch, arity), .scratch = scratch};
	for (int i = 0; i < arity; i++)
		compiler.variables[i] = program_argument(i);
	FunctionValue result = compile(&compiler, body);
	const Function *function = program_finish(compiler.program, arena, result);
	arena_rewind(scratch, mark);
	return function;
}
