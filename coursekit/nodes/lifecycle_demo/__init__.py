"""The package lifecycle: a managed talker, who listens to it, and who manages it."""
