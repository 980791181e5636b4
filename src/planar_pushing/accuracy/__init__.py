"""What accuracy costs: errors against certified values and times of methods for one quantity."""
