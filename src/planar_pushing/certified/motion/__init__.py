"""Motion over time: validated where it is an integral or a closed form, elsewhere to some thirty digits."""
