"""The ledger of claims: every checkable statement of the paper, its check, and the verdict."""
