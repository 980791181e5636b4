"""Scene files: their parts, and reading and writing."""
