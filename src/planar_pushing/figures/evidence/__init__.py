"""Figures of how accurate the results are and what they cost, each drawn from one dataset."""
