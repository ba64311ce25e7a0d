"""Interfaces: driving commands of vehicles that steer like cars."""
