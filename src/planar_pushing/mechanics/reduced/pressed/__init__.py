"""Any support and any centre of mass: what the contact feels of them, by subject."""
