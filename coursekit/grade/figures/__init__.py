"""The checks' figures beside their verdicts: they show plain values that a judge has checked, and hold no answers."""
