#include "cli/progress.h"

#include <stdio.h>
#include <unistd.h>

ProgressLine progress_line(bool wanted)
{
	return (ProgressLine){.shown = wanted && isatty(STDERR_FILENO)};
}

/* 75 -> "1:15"; unknown -> "?". */
static void format_time(double seconds, char *out, size_t size)
{
	long whole = (long)(seconds + 0.5);
	if (seconds < 0)
		snprintf(out, size, "?");
	else if (whole < 3600)
		snprintf(out, size, "%ld:%02ld", whole / 60, whole % 60);
	else
		snprintf(out, size, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
}

void progress_show(ProgressLine *line, const RenderProgress *progress)
{
	char gone[32], left[32];
	if (!line->shown)
		return;
	format_time(progress->seconds, gone, sizeof gone);
	format_time(progress->remaining, left, sizeof left);
	int width = fprintf(stderr, "\r%5.1f%%  %ld pixels, %.0f a second, %s gone, %s left",
			    100 * progress->share, progress->pixels, progress->rate, gone, left);
	if (width < line->width)
		fprintf(stderr, "%*s", line->width - width, "");
	line->width = width > line->width ? width : line->width;
	fflush(stderr);
}

void progress_clear(ProgressLine *line)
{
	if (line->shown && line->width > 0)
		fprintf(stderr, "\r%*s\r", line->width, "");
	line->width = 0;
}
