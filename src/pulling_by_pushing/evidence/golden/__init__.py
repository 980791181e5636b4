"""The golden data: enclosures of the results, and the comparison with them."""
