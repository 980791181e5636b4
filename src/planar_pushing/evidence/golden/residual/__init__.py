"""Every stored value put into the equation that it solves, in numbers of 32 digits."""
