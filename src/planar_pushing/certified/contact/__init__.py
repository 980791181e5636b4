"""Contact modes of one push: sticking, slipping, and which of them are consistent."""
