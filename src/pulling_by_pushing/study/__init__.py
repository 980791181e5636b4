"""Study files, and the datasets built from them."""
