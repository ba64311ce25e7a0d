"""Two interpreters that share one ROS graph and one virtual time, joined by a pair of pipes.

Programs that must not reach into each other run apart, yet meet on topics, services and actions as if they were together.
The leader's clock rules: the follower runs only as far as the leader allows, and both stop at the instant at which one of
them says something to the other, so a run is the same every time.
"""

from coursekit.joined.lockstep import Follower, Leader
from coursekit.joined.pipe import Broken, Pipe

__all__ = ["Broken", "Follower", "Leader", "Pipe"]
