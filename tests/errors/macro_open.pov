#macro A(X)
sphere { 0, X }
