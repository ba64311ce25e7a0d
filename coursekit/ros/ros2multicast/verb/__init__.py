"""The base class of verbs that packages add to `ros2 multicast`."""

from ros2cli.verb import VerbExtension as VerbExtension
