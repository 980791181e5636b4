"""Fits of supports and models to measured pushes."""
