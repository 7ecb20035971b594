/* Trees as text, for tests and for those who wonder: (sphere <0,1,0> 2 (texture {a texture})
 * hollow). */
#ifndef LANG_NODE_PRINT_H
#define LANG_NODE_PRINT_H

#include <stdio.h>

#include "lang/node.h"

/* The whole sequence on one line, without a line's end. */
void node_print(FILE *out, const Node *nodes);

#endif
