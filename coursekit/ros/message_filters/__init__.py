"""Filters between subscriptions and callbacks, which match messages of several topics by time."""

from .cache import Cache
from .chain import Chain
from .input_aligner import InputAligner
from .simple_filter import SimpleFilter, Subscriber
from .synchronizers import ApproximateTimeSynchronizer, TimeSynchronizer

__all__ = [
    "ApproximateTimeSynchronizer",
    "Cache",
    "Chain",
    "InputAligner",
    "SimpleFilter",
    "Subscriber",
    "TimeSynchronizer",
]
