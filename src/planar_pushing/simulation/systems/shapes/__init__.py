"""What pushes: a fence, which meets a point of the slider, or a finger, which meets a flat side."""
