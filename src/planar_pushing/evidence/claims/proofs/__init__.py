"""What the checks of the claims are made of."""
