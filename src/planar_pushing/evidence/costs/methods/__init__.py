"""Methods for one quantity, which the measurements compare."""
