"""Builders of the datasets: each is a function with the name of its dataset."""
