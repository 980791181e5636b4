"""Bracketed roots, and kernels mapped over arrays."""
