"""Pressure of a support in the compiled core, and its pieces."""
