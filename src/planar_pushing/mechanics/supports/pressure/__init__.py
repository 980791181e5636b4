"""The pressure of a support as the compiled core has it, and its pieces."""
