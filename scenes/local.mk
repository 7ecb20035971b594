EXTRA_DIST += scenes/cognac.pov scenes/cognac.png
