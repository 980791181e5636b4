"""Forces through the contact and the motions that they cause: curves, cones, centers."""
