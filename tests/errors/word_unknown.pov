sphere { 0, 1 pigmnet { rgb 1 } }
sphere { 0, 1 hollow_ }
