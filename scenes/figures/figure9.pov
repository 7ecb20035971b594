// Contact sheet of figure 9: see figures.sh.
#include "sheet.inc"
#macro Close(Name, Column, Caption)
  Panel(concat("9-", Name, ".png"), <480, 360>, <0, 0>, <480, 360>,
    <8 + Column * 488, 8>, 1, Caption)
#end
#macro Relaxed(Name, Column, Stored)
  #local Count = concat(str(Stored / 1000, 0, 0), "k photons");
  Close(Name, Column, concat("(", Name, ") ", Count, ", constrained relaxation"))
#end
Relaxed("a", 0, Stored_A)
Relaxed("b", 1, Stored_B)
Relaxed("c", 2, Stored_C)
Close("4", 3, "(d) reference: progressive passes")
Close("wide", 4, "All of (b)")
