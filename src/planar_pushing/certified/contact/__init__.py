"""Contact modes of a push: sticking, slipping, and which of them are consistent."""
