"""Packages: what colcon needs to build them without CMake, and how new ones are made."""
