"""The effects as a function of the contact's motion, with the rotation eliminated."""
