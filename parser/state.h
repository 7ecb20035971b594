/*
 * What the files of the parser room share: one reading of one scene. From the bottom up:
 *
 *     source.c      which token comes next: a stack of files and macro bodies, each an index into a
 * token array lexer.c       tokens to the grammar's tokens; identifiers get their values here,
 * directives are run in between directive.c   conditions, loops and everything else after a #;
 * calls the grammar again for what it holds grammar.y     trees and values reader.c      item after
 * item to lang's builders
 *
 * One call of the grammar is a Frame. It reads one token ahead at most, and gives that token back
 * (Reader.ahead).
 */
#ifndef PARSER_STATE_H
#define PARSER_STATE_H

#include <signal.h>
#include <stdbool.h>
#include <stdint.h>

#include "lang/context.h"
#include "lang/expression.h"
#include "lang/node.h"
#include "lang/symbol.h"
#include "parser/reader.h"
#include "parser/token.h"

/* Deeper nesting of macro calls and includes, and of the grammar's calls of itself, is taken for
 * endless recursion. */
enum { SOURCE_DEPTH_LIMIT = 1000, FRAME_DEPTH_LIMIT = 400 };

/* A sequence of nodes being made. */
typedef struct NodeList {
	Node *first, *last;
} NodeList;

/* A run of Reader.values: arguments of a call, components of a vector. */
typedef struct ValueRun {
	int start, count;
} ValueRun;

/* What a token or a symbol of the grammar carries. */
typedef union Semantic {
	Value value;
	Word word;
	const char *text;
	Node *node;
	NodeList nodes;
	ValueRun run;
} Semantic;

typedef enum SourceKind { SOURCE_FILE, SOURCE_MACRO } SourceKind;

typedef struct Source {
	SourceKind kind;
	const TokenFile *file;
	uint32_t position, end; /* indices into the file's tokens */
	const Expansion *via;
} Source;

/* A #for that runs. */
typedef struct Loop {
	Name *name;
	uint32_t opener, body;
	double end, step;
	int source_depth;
} Loop;

struct Macro {
	Name *name;
	const TokenFile *file;
	uint32_t begin, end;
	Name **parameters;
	int parameter_count;
};

/* Where a value that is being read ends although the grammar could go on: before a directive that
 * could use it. */
typedef enum FrameEnd {
	FRAME_RUNS_ON,        /* an item: braces end it */
	FRAME_ENDS_AT_DECLARE, /* #declare X = 1 #declare ...: X must have its value first */
	FRAME_ENDS_AT_DIRECTIVE,
} FrameEnd;

typedef struct Frame Frame;
struct Frame {
	int start;       /* the grammar's start token, 0 once it was given */
	FrameEnd ends;
	int depth;       /* of open braces, brackets and parentheses */
	int parentheses;
	bool complete;   /* the last token could end an expression or item */
	bool color;      /* a colour's parts (filter, red...) may follow */
	Word last_word;  /* the last token was this word */
	bool sized_function; /* `function 100, 100` was read: the next brace opens its body */
	bool failed;     /* a mistake was reported: do not build */
	bool recovering; /* skip to the brace that closes the block */
	int skip_depth;
	/* Where it began, to return to after a failure. */
	int source_depth, value_count, function_depth, brace_count;
	/* Results. */
	Value value;
	Node *nodes;
	ValueRun run;
	bool at_end;     /* no item is left */
	Frame *outer;
};

/* A token read ahead. */
typedef struct Ahead {
	int kind;
	Semantic value;
	Location where;
	Name *name;      /* an identifier is looked up again */
} Ahead;

struct Reader {
	Context context;
	const ReaderOptions *options;
	SymbolTable *symbols;
	TokenFile *files;
	Source *sources; int source_count, source_capacity;
	Loop *loops; int loop_count, loop_capacity;
	Value *values; int value_count, value_capacity;
	Location *braces; int brace_count, brace_capacity;
	Ahead ahead; bool has_ahead;
	Frame *frame; int frame_depth;
	int function_depth;  /* open function bodies */
	Value *target;       /* the variable that the last identifier token named */
	Name *last_name;     /* of the last identifier token; NULL after another token */
	int last_kind;       /* the last token given to the grammar */
	Semantic last_value;
	bool poisoned;       /* it stands for a mistake that was reported */
	bool stopped;        /* nothing more is read */
	int errors_before;   /* what the diagnostics had counted when the scene began */
	bool version_given;  /* by #version or the options */
	const Expansion
		*expansions[256]; /* the latest, by a hash: loops call from the same place */
};

/* reader.c: a mistake in this scene has been reported. */
bool reader_has_failed(const Reader *reader);

/* source.c */
Source *source_top(Reader *reader);
/* False, reported, when the nesting is too deep; reading then stops. */
bool source_push(Reader *reader, Source source, Location at);
/* Goes on at another token of the innermost source. LINK_NONE: at its end. */
void source_jump(Reader *reader, uint32_t index);
/* Leaves the innermost file or macro with its scope. */
void source_pop(Reader *reader);
const Expansion *source_expansion(Reader *reader, Location at, const char *name);
Location source_where(const Source *source, const Token *token);
/* Where the next raw token stands. */
Location source_here(Reader *reader);
/* The next token of the innermost source without leaving it; NULL at its end. */
const Token *source_peek(Reader *reader, uint32_t distance);
/* Takes the next raw token when it is that sign. */
bool source_accept_sign(Reader *reader, int sign);
/* Takes it or reports what was expected. */
bool source_take_sign(Reader *reader, int sign, const char *after);
/* The next raw token must be a name; NULL after a report. */
Name *source_take_name(Reader *reader, const char *what);

/* lexer.c */
int reader_yylex(Semantic *value, Location *where, Reader *reader);
/* The next token with every directive before it run. */
int lexer_fetch(Reader *reader, Semantic *value, Location *where);
/* Gives back the grammar's token read ahead. */
void lexer_give_back(Reader *reader, int kind, const Semantic *value, Location where);
/* Skips `( ... )` or `[ ... ]` that follows raw. */
void lexer_skip_group(Reader *reader, int open, int close);
/* The same from inside of it. */
void lexer_skip_rest(Reader *reader, int open, int close);

/* identifier.c */
/* The variable or array element that a name and the subscripts after it stand for; NULL when
 * undeclared (report says whether that is reported). */
Value *identifier_resolve(Reader *reader, Name *name, Location where, bool report);
/* Reports that a name is not declared, and what may be meant by it. */
void identifier_undeclared(Reader *reader, const Name *name, Location where);
/* The grammar's token for a value. */
int identifier_token(Reader *reader, Value value, Semantic *out);
/* The subscripts that follow, into subscripts; their number, -1 after a report. */
int identifier_subscripts(Reader *reader, double subscripts[8]);

/* macro.c */
void macro_define(Reader *reader, const Token *directive, Location where);
/* Reads the arguments and goes on with the macro's body; false after a report. */
bool macro_call(Reader *reader, const Macro *macro, Location where);

/* include.c */
void include_directive(Reader *reader, Location where);
/* Pushes the file; false after a report. */
bool include_file(Reader *reader, const char *name, Location where);

/* directive.c */
void directive_run(Reader *reader, const Token *token, Location where);
/* declare.c */
void declare_directive(Reader *reader, bool local, Location where);
void declare_undef(Reader *reader);
/* After a mistake: behind the next semicolon, or before a directive or a closing brace. */
void declare_skip(Reader *reader);
/* Gives name the value where it is declared, or NAME [i] ... its element: what #read fills in.
 * False after a report. */
bool declare_assign(Reader *reader, Value value);
/* Runs what is left of the macros that gave the frame's value, and takes the semicolon behind it;
 * false when there is none. */
bool declare_end(Reader *reader, const Frame *frame);
/* stream.c */
void stream_directive(Reader *reader, Word word, Location where);
void file_directive(Reader *reader, Word word, Location where);
/* function_header.c */
/* The token for `function` with what stands before its body. */
int function_header(Reader *reader);
/* The token that opens a body at the brace that is next. */
int function_body_begin(Reader *reader, const char **parameters, int count);
int function_sum(Reader *reader, Word word, Semantic *value, Location where);

/* frame.c: calls of the grammar. start is a token S_...; all return false after a report. */
bool frame_parse(Reader *reader, int start, FrameEnd ends, Frame *frame);
bool frame_string(Reader *reader, const char **out);
/* ( a, b, ... ) after the opening parenthesis was read; values are at
 * reader->values[frame->run.start]. */
bool frame_arguments(Reader *reader, Frame *frame);
/* ( condition ) */
bool frame_condition(Reader *reader, bool *out);

/* The grammar found a token it has no use for; expected says what it wanted, or NULL. Reports, and
 * sets out to skip. */
void frame_syntax_error(Reader *reader, Location where, const char *expected, const char *or_else);

/* tree.c: what the grammar's actions call. */
Node *tree_value(Reader *reader, NodeKind kind, Value value, Location where);
Value tree_vector(Reader *reader, ValueRun components, Location where);
/* An expression in an item: one node, or a vector of more than five components in nodes of five. */
Node *tree_expression(Reader *reader, Value value, Location where);
Node *tree_word(Reader *reader, NodeKind kind, Word word, Node *children, Location where);
/* Appends a node, or the sequence that begins with it. */
NodeList tree_append(NodeList list, Node *node);
void tree_push(Reader *reader, Value value);
Value tree_build(Reader *reader, Node *nodes);
Value tree_array(Reader *reader, ValueRun sizes, const Node *elements, Location where);
Value tree_function(Reader *reader, Node *body, Location where);
Value tree_trace(Reader *reader, ValueRun arguments, Location where);

#endif
