"""Integrals over the pressure of a support, in ball arithmetic."""
