#include "include_endless.pov"
