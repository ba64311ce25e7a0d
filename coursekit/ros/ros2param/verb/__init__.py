"""The base class of verbs that packages add to `ros2 param`."""

from ros2cli.verb import VerbExtension as VerbExtension
