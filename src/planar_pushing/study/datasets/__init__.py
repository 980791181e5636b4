"""Builders of the datasets: one module each, with `AXES`, the grid axes that it reads, and `build`."""
