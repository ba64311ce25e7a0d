"""Fusion of several sensors' motion measurements: Kalman filters with a 15-dimensional state in 3D."""
