"""What accuracy and each effect cost: errors, counts of evaluations, and times."""
