"""The log of a simulation: its variables, and streaming to a file."""
