"""Interfaces: disparity of stereo cameras."""
