"""The package lifecycle: a lifecycle talker, its listener, and a client that manages it."""
