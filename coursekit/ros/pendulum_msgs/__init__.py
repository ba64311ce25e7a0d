"""Interfaces: the pendulum of the real-time demo."""
