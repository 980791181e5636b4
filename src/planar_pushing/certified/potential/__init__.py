"""The potential of all effects in ball arithmetic, and its gradient with the rotation eliminated."""
