"""Interfaces: pose, colour and services of the turtle."""
