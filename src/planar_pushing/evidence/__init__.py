"""What the results rest on: golden data, claims, hard cases, and what accuracy costs."""
