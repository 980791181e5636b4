"""The mechanics of pushing."""
