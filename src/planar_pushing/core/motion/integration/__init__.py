"""Motion over time: from event to event, or in equal steps."""
