"""Any support pressure in ball arithmetic (PHYSICS.md, section 7)."""
