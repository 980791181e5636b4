"""Several contacts at once: fingers, walls and sides, and the motions that are consistent with all."""
