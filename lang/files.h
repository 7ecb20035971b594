/*
 * Files of a scene: #fopen, #read, #write, #fclose. A file holds floats, strings in double quotes
 * and vectors in angle brackets with commas between them, and comments as scenes have. Writing is
 * confined to the working directory and what is below it unless the context allows more. A
 * SceneFile lives in the parse arena; its stream is closed by files_close or, for all that were
 * left open, by files_close_all.
 */
#ifndef LANG_FILES_H
#define LANG_FILES_H

#include "lang/context.h"
#include "lang/value.h"
#include "lang/word.h"

typedef enum FileMode { FILE_READ, FILE_WRITE, FILE_APPEND } FileMode;

/* NULL after a reported error. Files for reading are looked for along the library paths as well. */
SceneFile *files_open(Context *context, const char *path, FileMode mode, Location where);
/* The next value, and the comma behind it. False at the end of the file, with a warning, or after a
 * reported error; *out is a float 0 then. */
bool files_read(Context *context, SceneFile *file, Value *out, Location where);
/* True when the last value had no comma behind it, reading beyond the end was tried or a mistake
 * was met (after #read POV-Ray forgets the file's name then), and for a closed file. */
bool files_at_end(const SceneFile *file);
/* One argument of #write: floats in %g form, vectors in angle brackets, strings as they are. */
void files_write(Context *context, SceneFile *file, Value value, Location where);
/* How #write makes an integer of so many bytes: uint8, sint16be ... */
typedef struct FileInteger FileInteger;
/* NULL when the word names none. */
const FileInteger *files_integer(Word word);
/* A float or each component of a vector, rounded to the nearest integer in range, two's complement.
 */
void files_write_integer(Context *context, SceneFile *file, const FileInteger *format, Value value,
			 Location where);
void files_close(SceneFile *file);
/* Closes what `#fopen` left open; the reader calls it at the end of the parse. */
void files_close_all(Context *context);

/* True when the scene may read the path; false after a reported error. Every opener of scene-named
 * files asks. */
bool files_may_read(Context *context, const char *path, Location where);
/* Where a file named in a scene really is: as it stands, else along the library paths; NULL when
 * nowhere. In the parse arena. */
const char *files_find(Context *context, const char *name);

#endif
