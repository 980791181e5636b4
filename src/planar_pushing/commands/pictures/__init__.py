"""The commands that draw a scene, a motion, or a page in the browser."""
