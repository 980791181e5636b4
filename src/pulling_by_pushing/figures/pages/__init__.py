"""Pages of the manual as Markdown with numbers, outputs and pictures, which a forge shows: `make pages`."""
