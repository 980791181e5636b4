"""Random and adversarial inputs, and what must hold for all of them."""
