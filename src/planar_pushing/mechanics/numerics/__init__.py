"""Roots in brackets, and kernels mapped over arrays."""
