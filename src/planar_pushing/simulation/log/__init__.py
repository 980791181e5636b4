"""The log of a simulation: its rows, its variables, and logs that are streamed to a file."""
