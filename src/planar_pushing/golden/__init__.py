"""Golden data: enclosures by ball arithmetic, on a route that shares nothing with the mechanics."""
