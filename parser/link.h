/* Ties the directives of a file together: #if to its branches and its #end, #break to what it
 * leaves. */
#ifndef PARSER_LINK_H
#define PARSER_LINK_H

#include "parser/token.h"

/* Fills in the links. Directives that lack their partner keep LINK_NONE; they are reported when
 * they are run. */
void link_directives(TokenFile *file);

#endif
