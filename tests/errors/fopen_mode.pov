#fopen F "x.txt" readwrite
