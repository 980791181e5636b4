"""Where the slider presses on the plane: one file a support."""
