"""Evidence for the results: golden data, claims, hard cases, and the cost of accuracy."""
