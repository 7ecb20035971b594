// README's picture of relaxation and footprints: see figures.sh.
#include "sheet.inc"
#macro Whole(Method, Column, Caption)
  Panel(concat("0-", Method, ".png"), <360, 270>, <0, 0>, <360, 270>,
    <6 + Column * 368, 6>, 1, Caption)
#end
#declare Photons = concat(str(Stored, 0, 0), " photons, ");
Whole("0", 0, concat(Photons, "15 nearest"))
Whole("3", 1, "the same photons, relaxed under constraints")
Whole("5", 2, "the same photons, their sheets drawn")
