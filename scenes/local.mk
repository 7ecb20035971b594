EXTRA_DIST += scenes/cognac.pov
