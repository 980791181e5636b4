"""Writing a log during a run, and what is left of it if the run is interrupted."""
