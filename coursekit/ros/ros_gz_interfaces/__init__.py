"""Interfaces: the newer Gazebo."""
