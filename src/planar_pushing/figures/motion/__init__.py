"""Pictures of motion over time, drawn from a log."""
