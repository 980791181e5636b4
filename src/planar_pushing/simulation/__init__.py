"""Simulation of the pushed slider over time, and its log."""
