"""Several contacts at one instant: every combination of their modes, and fingers driven by force."""
