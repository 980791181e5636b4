"""What the commands share: arguments and printed text."""
