"""The functions that on a robot come from cv_bridge's C++ part."""
