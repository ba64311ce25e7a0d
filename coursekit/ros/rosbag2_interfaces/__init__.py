"""Interfaces: control of the recorder and the player of bags."""
