#switch ("a")
#case (1) #end
#debug "on"
