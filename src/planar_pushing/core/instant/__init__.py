"""One push: the force across an edge along a path, and every mode of a point or a side."""
