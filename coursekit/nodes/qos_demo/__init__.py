"""The packages quality_of_service_demo_*: what deadline, lifespan and liveliness do, and what does not match."""
