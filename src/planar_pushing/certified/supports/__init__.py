"""Any support pressure in ball arithmetic (`paper/manual/theory/any_support.md`)."""
