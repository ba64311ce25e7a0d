"""The measurements of several sensors of a motion, put together: Kalman filters of 15 numbers in three dimensions."""
