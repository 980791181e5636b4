"""Shared code of the workflow's jobs: logs, and digests of the sources on which they depend."""
