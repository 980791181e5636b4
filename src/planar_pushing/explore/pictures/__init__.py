"""What the page draws, as columns of numbers and colours: no browser is needed to make them."""
