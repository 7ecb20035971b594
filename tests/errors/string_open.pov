sphere { 0, 1 }
#debug "never ends
box { 0, 1 }
