/*
 * The tree that the grammar builds for one item of a scene: a sequence of nodes for what stands
 * between braces, in reading order and with nothing decided. `sphere { <0,1,0>, 2 texture { T }
 * hollow scale 3 }` is
 *
 *     BLOCK sphere: VALUE <0,1,0>  VALUE 2  BLOCK texture: ITEM T   WORD hollow  WORD scale  VALUE
 * 3
 *
 * Commas leave no node (a map's entry [0.5, 0.7 color Red] reads VALUE 0.5 VALUE 0.7 VALUE Red).
 * Expressions are values by now. What a word may be followed by is the business of lang's builders
 * (lang/build.h), which walk it with a cursor. Nodes live in the parse arena and are gone after the
 * item.
 */
#ifndef LANG_NODE_H
#define LANG_NODE_H

#include <stddef.h>

#include "base/diag.h"
#include "lang/value.h"
#include "lang/word.h"

typedef enum NodeKind {
	NODE_VALUE, /* an expression: float, vector, colour, string */
	NODE_ITEM, /* an identifier that names anything else: texture, object, transform, function,
		      array, spline... */
	NODE_WORD, /* a reserved word without braces */
	NODE_BLOCK, /* a reserved word with braces */
	NODE_ENTRY, /* [ ... ] */
	NODE_PAIR, /* ( a, b ) */
} NodeKind;

typedef struct Node Node;
struct Node {
	NodeKind kind;
	Word word;      /* WORD, BLOCK */
	Value value;    /* VALUE, ITEM */
	Location where; /* of its first token */
	Node *children; /* BLOCK, ENTRY, PAIR: first node inside */
	Node *next;
};

#endif
