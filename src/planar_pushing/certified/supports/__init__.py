"""Any pressure of a support in ball arithmetic (`paper/manual/theory/any_support.md`)."""
