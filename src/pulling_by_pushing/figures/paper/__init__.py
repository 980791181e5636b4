"""Figures of the paper, and of pushes of its slider."""
