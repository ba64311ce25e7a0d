"""The base class of verbs that packages add to `ros2 node`."""

from ros2cli.verb import VerbExtension as VerbExtension
