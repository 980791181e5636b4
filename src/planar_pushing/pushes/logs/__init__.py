"""Measured pushes from published logs and from poses."""
