"""Figures 16 to 20: any slider."""
