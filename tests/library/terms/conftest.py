"""Results to query."""

import pytest

from smoke import smoke_results


@pytest.fixture(scope="session")
def cones(tmp_path_factory):
    """A folder of results with the motion cones of the small study."""
    return str(smoke_results(tmp_path_factory))
