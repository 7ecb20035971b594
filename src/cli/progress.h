/* One line on the terminal that says how far the render is; silent where standard error is no
 * terminal. */
#ifndef CLI_PROGRESS_H
#define CLI_PROGRESS_H

#include <stdbool.h>

#include "render/render.h"

typedef struct ProgressLine {
	bool shown;
	int width; /* characters on the line now */
} ProgressLine;

ProgressLine progress_line(bool wanted);
void progress_show(ProgressLine *line, const RenderProgress *progress);
/* Removes the line, so that other messages start on a clean one. */
void progress_clear(ProgressLine *line);

#endif
