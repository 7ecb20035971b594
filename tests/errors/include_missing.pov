#include "there is no such file.inc"
