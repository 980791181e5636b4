"""Pictures of the explorer, and what the pointer does on them."""
