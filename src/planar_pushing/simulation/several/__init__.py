"""Motion over time of an object that several pushers and walls touch, without inertia."""
