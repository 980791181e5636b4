"""The mechanics of pushing: numpy and scipy, nothing more."""
