"""The base class of verbs that packages add to `ros2 bag`."""

from ros2cli.verb import VerbExtension as VerbExtension
