"""The places at which the numbers get hard, a module each."""
