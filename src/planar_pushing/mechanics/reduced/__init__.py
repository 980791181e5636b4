"""The effects as a function of the motion of the contact: the rotation is eliminated."""
