"""Logs of motion over time to thirty digits, by two orders of one integrator; nothing is validated."""
