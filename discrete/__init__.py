"""The nets: space forms, the quad rule, complexes, K-surfaces, assembly, surgery, greedy cuts."""
