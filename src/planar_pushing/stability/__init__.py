"""Stable pushes with a flat side on the fence, and statements for any pressure."""
