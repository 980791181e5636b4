"""The time-stepping integrator: one incremental problem per step."""
