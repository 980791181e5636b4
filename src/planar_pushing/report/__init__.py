"""The report: its numbers and tables, read from the results, and its setting as a PDF."""
