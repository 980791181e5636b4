"""The figures of the paper, one module for each, drawn from the datasets of a study."""
