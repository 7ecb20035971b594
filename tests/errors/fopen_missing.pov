#fopen F "no such file" read
