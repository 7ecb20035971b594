/*
 * media { } and density { }: read and checked, not rendered yet. A scene that has any is told so
 * once.
 */
#ifndef LANG_BUILD_MEDIA_H
#define LANG_BUILD_MEDIA_H

#include "lang/context.h"
#include "lang/node.h"

/* What a media or density identifier holds. */
typedef struct Media {
	bool any; /* the block said something */
} Media;

/* media { } or density { }. */
const Media *build_media(Context *context, const Node *block);

/* Warns about a feature that is read but not rendered, once a scene. */
typedef enum Unsupported {
	UNSUPPORTED_MEDIA, UNSUPPORTED_RADIOSITY, UNSUPPORTED_SUBSURFACE, UNSUPPORTED_PHOTONS
} Unsupported;
void build_unsupported(Context *context, Unsupported feature, Location where);

#endif
