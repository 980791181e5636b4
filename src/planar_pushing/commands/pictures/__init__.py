"""The commands that draw: a scene, a motion, or a page on which a scene is dragged."""
