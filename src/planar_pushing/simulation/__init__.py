"""Motion over time: the pushed slider simulated, and its log."""
