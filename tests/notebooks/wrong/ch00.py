"""Chapter 0."""

WRONG = {
    "ch00.q1": ['me = "Vera"', 'me = " "', "me = 7"],
    "ch00.q2": ['presses = [("up", 2.0)]', 'presses = [("left", 1.57), ("up", 4.0)]', 'presses = [("forward", 1.0)]'],
    "ch00.q3": ['wishes = {1: "because", 2: "because", 3: "because"}', 'wishes = ["a robot that brings me coffee"]'],
}
