sphere { 0, 1 }
/* begins /* nests */ and never ends
box { 0, 1 }
