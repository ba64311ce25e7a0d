"""A buffer and its complaints."""

import pytest

from coursekit.tf import FrameBuffer


@pytest.fixture
def said():
    return []


@pytest.fixture
def buffer(said):
    return FrameBuffer(report=lambda level, text: said.append(f"{level}: {text}"))
