// The old name of filter is still known.
#declare Old = color red 0.5 green 1 alpha 0.7
sphere { 0, 1 pigment { Old } }
sphere { 0, 1 pigment { rgb <1, 0, 1> alpha } }
