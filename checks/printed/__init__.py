"""The formulas as the paper prints them; parameters default to what is printed."""
