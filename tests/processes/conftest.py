"""A session on either clock."""

import pytest

from coursekit.processes.session import Session


@pytest.fixture(params=["wall", "virtual"])
def session(request):
    with Session(virtual=request.param == "virtual").use() as session:
        yield session
