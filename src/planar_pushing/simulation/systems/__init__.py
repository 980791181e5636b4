"""The equations of motion of a pushed slider, without and with inertia."""
