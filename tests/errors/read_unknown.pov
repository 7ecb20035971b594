#read (Nothing, A)
