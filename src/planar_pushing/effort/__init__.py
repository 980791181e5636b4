"""What a scene costs: how often each of its effects is evaluated, and how long it takes."""
