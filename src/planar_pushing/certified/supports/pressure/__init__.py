"""Integrals over a support's pressure, in ball arithmetic."""
