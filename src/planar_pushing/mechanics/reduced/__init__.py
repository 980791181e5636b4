"""What the contact feels of the slider: the effects with the rotation eliminated."""
