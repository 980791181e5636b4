"""The time-stepping integrator: one incremental problem a step."""
