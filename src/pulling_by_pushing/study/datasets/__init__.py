"""Builders of the datasets: one module per dataset, with a function `build`."""
