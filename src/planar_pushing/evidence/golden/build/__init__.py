"""The golden data computed from the certified physics."""
