/*
 * Images and voxels that a scene names: image_map, bump_map, material_map, image_pattern and
 * density_file. Files are looked for as they stand and along the library paths.
 */
#ifndef LANG_BUILD_IMAGE_H
#define LANG_BUILD_IMAGE_H

#include "lang/cursor.h"
#include "surface/image_map.h"
#include "surface/pattern_data.h"

/* The inside of an image_map, image_pattern, bump_map or material_map block; what is left is for
 * the caller (the textures of a material map). bump_size, if the block has it, goes to *bump_size.
 * An image_map's colours are decoded to the scene's working space; the others are data and stay as
 * they are, unless the block gives a gamma. NULL after a reported error. */
const ImageMap *build_image(Cursor *inside, Word kind, double *bump_size);
/* function WIDTH, HEIGHT { ... } in place of a file: the block fills the map's raster. False after
 * a reported error. */
bool build_function_image(Context *context, const Node *block, ImageMap *map);
/* The string of density_file df3 "name". NULL after a reported error. */
const DensityData *build_density_file(Cursor *cursor);

#endif
