/* global_settings { }. */
#ifndef LANG_BUILD_SETTINGS_H
#define LANG_BUILD_SETTINGS_H

#include "lang/context.h"
#include "lang/node.h"

/* Changes the builder's settings; what a block does not mention stays. */
void build_global_settings(Context *context, const Node *block);
/* A setting that stands at the top level by itself, as old versions had it: max_trace_level 5.
 * Takes it and its number; false when there is none. */
bool build_old_setting(Context *context, const Node **at);

#endif
