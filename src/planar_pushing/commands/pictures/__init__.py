"""The commands that draw a scene, animate a motion, or open a page in the browser."""
