"""The numbers of the report's parts, one module for each group of sections."""
