"""Motion over time within a mode, as integrals over the spin ratio."""
