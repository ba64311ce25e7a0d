"""Two interpreters that share one ROS graph and one virtual time, connected by a pair of pipes.

Programs that must not interfere with each other run in separate interpreters, yet share topics, services and actions as if
they were in one. The leader's clock rules: the follower runs only as far as the leader allows, and both stop at the instant
at which one of them sends an event to the other, so every run is the same.
"""

from coursekit.joined.lockstep import Follower, Leader
from coursekit.joined.pipe import Broken, Pipe

__all__ = ["Broken", "Follower", "Leader", "Pipe"]
