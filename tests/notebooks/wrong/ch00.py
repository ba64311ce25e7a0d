"""Chapter 0."""

WRONG = {
    "ch00.q1": ['me = "Vera"', 'me = " "', "me = 7"],
    "ch00.q2": ['presses = [("up", 2.0)]', 'presses = [("left", 1.57), ("up", 4.0)]', 'presses = [("forward", 1.0)]', 'presses = [("left", float("nan")), ("up", 2.0)]'],
    "ch00.q3": [
        'wishes = {1: "because", 2: "because", 3: "because"}',
        'wishes = ["a robot that brings me coffee"]',
        'wishes = {1: "asdf asdf asdf asdf", 2: "asdf jkl asdf jkl", 3: "asdf qwer jkl uiop"}',
        'wishes = dict.fromkeys((1, 2, 3), "It shall bring me coffee")',
        'wishes = {True: "It shall bring me coffee", 2.0: "It shall bring me tea", 3: "It shall sing me songs"}',
    ],
}
RIGHT = {
    "ch00.q1": ['me = "Suharto -"', 'me = "山田太郎"', """me = "Gerard 't Hooft" """],
    "ch00.q2": ['presses = [["left", 1.57], ["up", 2]]'],
    "ch00.q3": [
        "wishes = {7: 'It shall know where its arm is', 8: 'It shall know my flat', 9: 'It shall find its way by itself'}",
        "wishes = {1: 'Quiero ver lo que hace', 6: 'Quiero un robot con brazo', 9: 'Que encuentre solo el camino'}",
    ],
}
