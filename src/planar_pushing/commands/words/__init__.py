"""Arguments and printed text that the commands share."""
