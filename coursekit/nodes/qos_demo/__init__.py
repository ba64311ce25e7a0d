"""The packages quality_of_service_demo_*: the effects of deadline, lifespan and liveliness, and incompatible profiles."""
