"""Marks, and their two renderers: matplotlib and SVG."""
