#include <math.h>

#include "surface/function_internal.h"

const InternalFunction function_internal_blobs[] = {{0, 0, NULL}};
