"""Files of a net: PLY, OBJ, STL, GLB, VTK and NPZ for the surface, PNG and SVG for the disk."""
