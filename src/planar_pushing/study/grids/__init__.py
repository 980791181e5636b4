"""Large grids: chunks of a study, files written block by block, and what they cost."""
