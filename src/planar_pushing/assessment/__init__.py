"""Which effects a push calls for, what accuracy costs, and how sure the answer is."""
