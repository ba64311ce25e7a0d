"""Speed, as ratios against the peer in one run. `make bench` prints them; tests never time."""
