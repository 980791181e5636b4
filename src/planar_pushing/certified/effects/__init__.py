"""Contact modes under any tuple of effects, in ball arithmetic."""
