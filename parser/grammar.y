/*
 * The grammar of items and expressions. Directives never come here: the lexer runs them
 * (directive.c), and calls this grammar with another start token for what they hold. Each start
 * rule ends without looking ahead where the language allows it, and gives back the token it read
 * ahead where not.
 *
 * As in POV-Ray, `<` compares inside parentheses only, and opens a vector elsewhere. `&` and `|`
 * are taken from left to right, but for function bodies, where `&` binds tighter (measured).
 */
%require "3.8"
%expect 0
%define api.pure full
%define api.prefix {reader_yy}
%define api.value.type {Semantic}
%define api.location.type {Location}
%define parse.error custom
%locations
%param {Reader *reader}

%code requires {
#include "parser/state.h"
}

%code {
#include "lang/function.h"
#include "lang/spline.h"

#define YYINITDEPTH 60
#define YYMAXDEPTH 4000
#define YYLLOC_DEFAULT(result, right, count) ((result) = YYRHSLOC(right, (count) ? 1 : 0))

static void reader_yyerror(Location *where, Reader *reader, const char *message);

/* Ends a call of the grammar. */
#define FINISH() \
	do { \
		lexer_give_back(reader, yychar, &yylval, yylloc); \
		YYACCEPT; \
	} while (0)

static inline Value binary(Reader *reader, Operator op, Value a, Value b, Location where)
{
	if (a.kind == VALUE_FLOAT && b.kind == VALUE_FLOAT) {
		switch (op) {
		case OP_ADD: return value_float(a.number + b.number);
		case OP_SUB: return value_float(a.number - b.number);
		case OP_MUL: return value_float(a.number * b.number);
		default: break;
		}
	}
	return expression_binary(&reader->context, op, a, b, where);
}

static inline Value *run_values(Reader *reader, ValueRun run)
{
	reader->value_count = run.start;
	return reader->values + run.start;
}

static inline ValueRun run_begin(Reader *reader, Value value)
{
	ValueRun run = {reader->value_count, 1};
	tree_push(reader, value);
	return run;
}

static inline ValueRun run_add(Reader *reader, ValueRun run, Value value)
{
	tree_push(reader, value);
	run.count++;
	return run;
}

static inline Value opaque_black(void) { return (Value){.kind = VALUE_COLOR, .size = 5}; }
}

/* Start tokens: what this call reads. */
%token S_ITEM       /* the next item of the scene */
%token S_VALUE      /* what #declare gives a name */
%token S_ARGUMENT   /* a macro's argument */
%token S_EXPRESSION
%token S_STRING     /* a string, without looking ahead */
%token S_CONDITION  /* ( condition ) */
%token S_ARGUMENTS  /* a, b, ... ) */
%token S_SUBSCRIPT  /* i ] */
%token S_NODES      /* { nodes } */

%token <value> VALUE ITEM CALLABLE
%token <word> WORD TEXTURE CALL TRACE SUM INTERNAL COLOR PART FIRST_PART
%token <text> MEMBER
%token XYZ TIGHT_AND /* & inside function bodies */
%token FUNCTION FUNCTION_ITEM FUNCTION_SIZED ARRAY
%token LESS_EQUAL "'<='" GREATER_EQUAL "'>='" NOT_EQUAL "'!='"
%token INVALID

%type <value> expression condition string thing array function element_value call
%type <nodes> nodes elements textures
%type <node> node block texture braces entry term element function_body
%type <run> components arguments sizes
%type <word> plain

%right '?' ':'
%left '|' '&'
%left TIGHT_AND
%left '=' NOT_EQUAL '<' '>' LESS_EQUAL GREATER_EQUAL
%precedence LOW
%precedence TEXTURE '{'
%left PART
%left '+' '-'
%left '*' '/'
%precedence UNARY
%precedence MEMBER

%%

start:
	  S_ITEM block                          { reader->frame->nodes = $2; FINISH(); }
	| S_ITEM texture                        { reader->frame->nodes = $2; FINISH(); }
	| S_ITEM WORD expression                { /* a setting of old versions: max_trace_level 5 */
		reader->frame->nodes = tree_word(reader, NODE_WORD, $2, NULL, @2);
		reader->frame->nodes->next = tree_expression(reader, $3, @3);
		FINISH();
	  }
	| S_ITEM                                {
		if (yychar != READER_YYEOF) {
			frame_syntax_error(reader, yylloc, NULL, NULL);
			YYABORT;
		}
		reader->frame->at_end = true;
		FINISH();
	  }
	| S_VALUE element_value                 { reader->frame->value = $2; FINISH(); }
	| S_ARGUMENT element_value                   { reader->frame->value = $2; FINISH(); }
	| S_EXPRESSION expression               { reader->frame->value = $2; FINISH(); }
	| S_STRING string                       { reader->frame->value = $2; FINISH(); }
	| S_CONDITION '(' condition ')'         { reader->frame->value = $3; FINISH(); }
	| S_ARGUMENTS arguments ')'             { reader->frame->run = $2; FINISH(); }
	| S_SUBSCRIPT condition ']'             { reader->frame->value = $2; FINISH(); }
	| S_NODES braces                        { reader->frame->nodes = $2; FINISH(); }
	;

/* Items */

nodes:
	  %empty                                { $$ = (NodeList){0}; }
	| nodes node                            { $$ = tree_append($1, $2); }
	| nodes ','
	| nodes ';'
	;

node:
	  expression %prec LOW                  { $$ = tree_expression(reader, $1, @1); }
	| ITEM                                  { $$ = tree_value(reader, NODE_ITEM, $1, @1); }
	| plain                                 { $$ = tree_word(reader, NODE_WORD, $1, NULL, @1); }
	| block
	| texture
	| entry
	| term
	| function                              {
		Node *value = tree_value(reader, NODE_ITEM, $1, @1);
		$$ = tree_word(reader, NODE_BLOCK, W_function, value, @1);
	  }
	| FUNCTION_SIZED expression ',' expression function {
		Node *value = tree_value(reader, NODE_ITEM, $5, @1);
		value->next = tree_value(reader, NODE_VALUE, $2, @2);
		value->next->next = tree_value(reader, NODE_VALUE, $4, @4);
		$$ = tree_word(reader, NODE_BLOCK, W_function, value, @1);
	  }
	;

plain: WORD | TEXTURE;

block: WORD braces                              { $$ = tree_word(reader, NODE_BLOCK, $1, $2, @1); };
texture: TEXTURE braces                         { $$ = tree_word(reader, NODE_BLOCK, $1, $2, @1); };

braces:
	  '{' nodes '}'                         { $$ = $2.first; }
	| '{' nodes error '}'                   { $$ = $2.first; yyerrok; }
	;

entry: '[' nodes ']'                            {
		$$ = tree_word(reader, NODE_ENTRY, W_NONE, $2.first, @1);
	  }
	;

term:
	  XYZ '(' condition ',' condition ',' condition ')' ':' expression %prec LOW {
		Node *powers = tree_value(reader, NODE_VALUE, $3, @3);
		powers->next = tree_value(reader, NODE_VALUE, $5, @5);
		powers->next->next = tree_value(reader, NODE_VALUE, $7, @7);
		powers->next->next->next = tree_value(reader, NODE_VALUE, $10, @10);
		$$ = tree_word(reader, NODE_ENTRY, W_NONE, powers, @1);
	  }
	| '(' condition ',' condition ')'       { /* pwr(2.5, 0.3) */
		Node *pair = tree_value(reader, NODE_VALUE, $2, @2);
		pair->next = tree_value(reader, NODE_VALUE, $4, @4);
		$$ = tree_word(reader, NODE_PAIR, W_NONE, pair, @1);
	  }
	;

textures:
	  texture                               { $$ = tree_append((NodeList){0}, $1); }
	| textures texture                      { $$ = tree_append($1, $2); }
	;

function:
	  FUNCTION '{' function_body '}'        { $$ = tree_function(reader, $3, @1); }
	| FUNCTION_ITEM '{' nodes '}'           { $$ = tree_function(reader, $3.first, @1); }
	| FUNCTION '{' error '}'                { $$ = tree_function(reader, NULL, @1); yyerrok; }
	| FUNCTION_ITEM '{' nodes error '}'     { $$ = value_none(); yyerrok; }
	;

function_body: condition                        { $$ = tree_value(reader, NODE_VALUE, $1, @1); };

/* Values that are no expressions */

thing:
	  ITEM
	| block                                 { $$ = tree_build(reader, $1); }
	| textures %prec LOW                    { $$ = tree_build(reader, $1.first); }
	| function
	| array
	;

array:
	  ARRAY sizes %prec LOW                 { $$ = tree_array(reader, $2, NULL, @1); }
	| ARRAY sizes '{' elements '}'          { $$ = tree_array(reader, $2, $4.first, @1); }
	;

sizes:
	  '[' condition ']'                     { $$ = run_begin(reader, $2); }
	| sizes '[' condition ']'               { $$ = run_add(reader, $1, $3); }
	;

elements:
	  %empty                                { $$ = (NodeList){0}; }
	| elements element                      { $$ = tree_append($1, $2); }
	| elements ','
	;

element:
	  element_value                         { $$ = tree_value(reader, NODE_VALUE, $1, @1); }
	| '{' elements '}'                      {
		$$ = tree_word(reader, NODE_ENTRY, W_NONE, $2.first, @1);
	  }
	;

element_value: expression %prec LOW | thing;

string: VALUE | call;

/* Expressions */

call:
	  CALL '(' arguments ')'                {
		$$ = expression_call(&reader->context, $1, run_values(reader, $3), $3.count, @1);
	  }
	| CALL '(' ')'                          {
		$$ = expression_call(&reader->context, $1, NULL, 0, @1);
	  }
	| CALLABLE '(' arguments ')'            {
		$$ = expression_apply(&reader->context, $1, run_values(reader, $3), $3.count, @1);
	  }
	| CALLABLE '(' arguments ',' WORD ')'   {
		Value spline = spline_as(&reader->context, $1, $5, @5);
		$$ = expression_apply(&reader->context, spline, run_values(reader, $3), $3.count,
				      @1);
	  }
	| CALLABLE '(' ')'                      {
		$$ = expression_apply(&reader->context, $1, NULL, 0, @1);
	  }
	| TRACE '(' arguments ')'               { $$ = tree_trace(reader, $3, @1); }
	| SUM condition ',' condition ',' condition ')' {
		Value range[2] = {$2, $4};
		$$ = function_loop_close(&reader->context, $1, range, $6, @1);
	  }
	| INTERNAL '(' condition ')'            {
		$$ = function_internal(&reader->context, $3, @1);
	  }
	;

arguments:
	  condition                             { $$ = run_begin(reader, $1); }
	| ITEM                                  { $$ = run_begin(reader, $1); }
	| arguments ',' condition               { $$ = run_add(reader, $1, $3); }
	| arguments ',' ITEM                    { $$ = run_add(reader, $1, $3); }
	;

expression:
	  VALUE
	| call
	| '(' condition ')'                     { $$ = $2; }
	| '<' components '>'                    { $$ = tree_vector(reader, $2, @1); }
	| '<' components ',' '>'                { $$ = tree_vector(reader, $2, @1); }
	| expression MEMBER                     {
		$$ = expression_member(&reader->context, $1, $2, @1);
	  }
	| '-' expression %prec UNARY            {
		$$ = expression_unary(&reader->context, OP_NEG, $2, @1);
	  }
	| '+' expression %prec UNARY            {
		$$ = expression_unary(&reader->context, OP_PLUS, $2, @1);
	  }
	| '!' expression %prec UNARY            {
		$$ = expression_unary(&reader->context, OP_NOT, $2, @1);
	  }
	| expression '+' expression             { $$ = binary(reader, OP_ADD, $1, $3, @2); }
	| expression '-' expression             { $$ = binary(reader, OP_SUB, $1, $3, @2); }
	| expression '*' expression             { $$ = binary(reader, OP_MUL, $1, $3, @2); }
	| expression '/' expression             { $$ = binary(reader, OP_DIV, $1, $3, @2); }
	| COLOR expression %prec LOW            {
		$$ = expression_color(&reader->context, $1, $2, @1);
	  }
	| expression PART expression %prec PART {
		$$ = expression_color_part(&reader->context, $1, $2, $3, @2);
	  }
	| FIRST_PART expression %prec PART      {
		$$ = expression_color_part(&reader->context, opaque_black(), $1, $2, @1);
	  }
	;

components:
	  expression %prec LOW                  { $$ = run_begin(reader, $1); }
	| components ',' expression %prec LOW   { $$ = run_add(reader, $1, $3); }
	| components expression %prec LOW       { $$ = run_add(reader, $1, $2); }
	;

condition:
	  expression %prec LOW
	| condition '<' condition               { $$ = binary(reader, OP_LESS, $1, $3, @2); }
	| condition '>' condition               { $$ = binary(reader, OP_GREATER, $1, $3, @2); }
	| condition LESS_EQUAL condition        { $$ = binary(reader, OP_LESS_EQUAL, $1, $3, @2); }
	| condition GREATER_EQUAL condition     {
		$$ = binary(reader, OP_GREATER_EQUAL, $1, $3, @2);
	  }
	| condition '=' condition               { $$ = binary(reader, OP_EQUAL, $1, $3, @2); }
	| condition NOT_EQUAL condition         { $$ = binary(reader, OP_NOT_EQUAL, $1, $3, @2); }
	| condition '&' condition               { $$ = binary(reader, OP_AND, $1, $3, @2); }
	| condition TIGHT_AND condition         { $$ = binary(reader, OP_AND, $1, $3, @2); }
	| condition '|' condition               { $$ = binary(reader, OP_OR, $1, $3, @2); }
	| condition '?' condition ':' condition {
		$$ = expression_conditional(&reader->context, $1, $3, $5, @2);
	  }
	;

%%

/* Only for what is no syntax error: memory exhausted. */
static void reader_yyerror(Location *where, Reader *reader, const char *message)
{
	(void)message;
	reader->frame->failed = true;
	diag_error(reader->context.diag, *where, "this is nested too deeply");
}

/* What a token is called when it is expected; NULL for those that say nothing to a user. */
static const char *expected_name(yysymbol_kind_t symbol)
{
	if (symbol == YYSYMBOL_VALUE)
		return "a value";
	if (symbol == YYSYMBOL_YYEOF || (symbol >= YYSYMBOL_S_ITEM && symbol <= YYSYMBOL_INVALID))
		return NULL;
	return yysymbol_name(symbol);
}

static int yyreport_syntax_error(const yypcontext_t *context, Reader *reader)
{
	yysymbol_kind_t expected[2];
	int count = yypcontext_expected_tokens(context, expected, 2);
	const char *first = count > 0 ? expected_name(expected[0]) : NULL;
	const char *second = count > 1 ? expected_name(expected[1]) : NULL;
	frame_syntax_error(reader, *yypcontext_location(context), first, second);
	return 0;
}
