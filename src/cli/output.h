/* Output files: their names, and a film written in the format that was asked for. */
#ifndef CLI_OUTPUT_H
#define CLI_OUTPUT_H

#include "cli/animation.h"
#include "image/image.h"
#include "render/passes.h"
#include "scene/scene.h"

/* The file of a frame: the scene's own name unless another was said, the frame's number, the
 * format's extension. "-" stays as it is. Lives in the options' arena. */
const char *output_path(const Options *options, const Animation *animation, int frame);

/* The scene's name without folders and extension. */
const char *output_scene_name(const Options *options);

/* What a written file tells about its making. */
typedef struct OutputOrigin {
	const char *scene, *switches;
	uint64_t seed;
	const Settings *settings; /* of the scene: its gamma */
	ImageRegion region;       /* that is rendered, when it is a part */
	PassStatistics passes;    /* zeros while the picture is unfinished */
} OutputOrigin;

/* Layers that the format can keep, for film_create; those of photons only where there are any. */
unsigned output_layers(const Options *options, bool photons);

/* Beside, then renamed. False on failure, reported. */
bool output_write(const Options *options, const Film *film, const OutputOrigin *origin,
		  const char *path, Diag *diag);

#endif
