/* From the tree of a function's body to its program. */
#ifndef LANG_FUNCTION_COMPILE_H
#define LANG_FUNCTION_COMPILE_H

#include "lang/expression_tree.h"
#include "surface/function.h"

/* scratch is left as it was; the function lives in the arena. NULL when the program would be too
 * long. */
const Function *function_compile(const Expression *body, int arity, Arena *scratch, Arena *arena);

#endif
