"""Contact modes with any tuple of effects, in ball arithmetic."""
