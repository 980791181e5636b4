"""The event-driven integrator: from event to event, with a choice of mode at each."""
