"""Motion over time: validated if it is an integral or a closed form, otherwise to about thirty digits."""
