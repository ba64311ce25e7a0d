"""explore_lite: a robot drives to unseen areas until everything is seen."""
