"""Scene and study files: their models, and how they are read and written."""
