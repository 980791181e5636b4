"""The paper: its study, datasets and figures, certified, and the report on its replication."""
