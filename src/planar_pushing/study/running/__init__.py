"""What the workflow's jobs share: their logs, the sources they depend on, and locks of killed runs."""
