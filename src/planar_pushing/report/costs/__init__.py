"""Numbers and tables of what accuracy costs: errors, hard cases, effects, and times."""
