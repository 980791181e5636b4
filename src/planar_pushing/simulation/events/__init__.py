"""The event-driven integrator: integration from event to event, with a choice of mode at each event."""
