#fopen F "/no_such_folder/x.txt" write
#fopen G "../x.txt" write
