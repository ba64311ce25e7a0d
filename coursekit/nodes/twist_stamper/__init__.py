"""twist_stamper: Twist with a stamp and without."""
