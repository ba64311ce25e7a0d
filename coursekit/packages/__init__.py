"""Packages: colcon's extensions to build them without CMake, and the creation of new ones."""
