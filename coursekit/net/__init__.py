"""The session's graph on a real ROS 2 network, over Eclipse Zenoh in the wire format of rmw_zenoh.

Nothing here is imported before a network is joined, and `zenoh` not before one is opened.
"""
