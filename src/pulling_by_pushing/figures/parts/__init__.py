"""Code shared by several figures: numbers and captions, curves, frames, supports over rods, methods."""
