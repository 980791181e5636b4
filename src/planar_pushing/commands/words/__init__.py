"""Arguments and printed text, which the commands share."""
