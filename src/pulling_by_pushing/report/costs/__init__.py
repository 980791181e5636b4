"""Numbers and tables on the cost of accuracy: errors, hard cases, effects and times."""
