"""Figures 1 to 15: each selects what it plots from the datasets, and draws that alone."""
