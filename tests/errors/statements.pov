5
"text"
sphere
<1,2,3>
box { 0, Undeclared }
