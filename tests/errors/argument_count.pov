#macro Ball(P, R) sphere { P, R } #end
Ball(<0,0,0>)
Ball(<0,0,0>, 1, 2)
