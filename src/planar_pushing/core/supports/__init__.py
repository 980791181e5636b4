"""The resistance of supports, inertia and loads to a twist, and the reduced potential of a contact."""
