"""Where pusher and slider are at an instant: rows of a run, its state, and the contact."""
