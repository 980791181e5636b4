"""Pressure of a support in the core, and its pieces."""
