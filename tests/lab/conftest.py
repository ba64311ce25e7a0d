"""What most tests of the lab stand on: a session on the virtual clock, without a panel of the test before."""

import pytest

from coursekit.lab.panel import end_panels
from coursekit.processes.session import Session


@pytest.fixture
def session():
    """A session in which time passes only while all wait; its panels end with it."""
    with Session(virtual=True).use() as made:
        yield made
        end_panels()
