"""Measured pushes: their dataset, readers of published logs, and simulated pushes."""
