"""logging_demo: what loggers can do, and a service that changes their levels."""
