#case (1)
#debug "never"
