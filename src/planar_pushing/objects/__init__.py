"""An object in its own frame: its scene, inverse problems for planners, and other tools."""
