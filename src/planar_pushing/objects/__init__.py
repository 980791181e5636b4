"""An object in a frame of its own: its scene, the inverse questions of planners, and other tools."""
