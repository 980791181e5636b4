"""Physics in ball arithmetic, on a route that shares nothing with the mechanics."""
