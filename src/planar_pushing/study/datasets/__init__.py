"""Builders of the datasets: one module each, with a function `build`."""
