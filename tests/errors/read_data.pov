#version 3.7;
#fopen Data "read_data.txt" read
#while (defined(Data))
#read (Data, V)
#end
#fopen Data "read_word.txt" read
#read (Data, S, V)
#fopen Data "read_few.txt" read
#declare C = 5;
#read (Data, A, B)
#if (!defined(Data)) #error "a comma stands behind the last value" #end
#read (Data, C, D)
#if (defined(Data) | defined(D) | A != 7 | B != 2 | C != 5) #error "wrong" #end
