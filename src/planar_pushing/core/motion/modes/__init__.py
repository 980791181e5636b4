"""The motion in a mode, the margins that end it, and the modes that can follow an instant."""
