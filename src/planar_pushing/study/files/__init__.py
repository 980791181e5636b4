"""Scene and study files: their models, and functions that read and write them."""
