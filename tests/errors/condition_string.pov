#if ("yes") #debug "yes" #end
