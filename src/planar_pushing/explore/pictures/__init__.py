"""What the page draws, as columns of numbers and colors: no browser is needed to make them."""
