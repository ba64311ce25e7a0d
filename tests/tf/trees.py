"""Poses, and random trees of frames."""

import math
import random

S = 10**9


def at(x, y=0.0, yaw=0.0):
    return x, y, 0.0, 0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)


def random_pose(dice):
    parts = [dice.gauss(0, 1) for _ in range(4)]
    length = math.sqrt(sum(part * part for part in parts))
    return (*(dice.uniform(-5, 5) for _ in range(3)), *(part / length for part in parts))


def random_tree(seed, size=12, stamps=6):
    """(parent, child, stamp, pose, static) in the order of their publication."""
    dice = random.Random(seed)
    data = []
    static = {number: dice.random() < 0.4 for number in range(1, size)}
    parents = {number: dice.randrange(number) for number in range(1, size)}
    poses = {number: random_pose(dice) for number in range(1, size)}
    for number in range(1, size):
        if static[number]:
            data.append((f"f{parents[number]}", f"f{number}", 0, poses[number], True))
    for step in range(1, stamps + 1):
        for number in range(1, size):
            if not static[number]:
                stamp = step * S + dice.randrange(S // 2)
                data.append((f"f{parents[number]}", f"f{number}", stamp, random_pose(dice), False))
    return data


def times(seed, count=3):
    """Times to look up: some between the data, some outside."""
    dice = random.Random(seed)
    return [0, *(dice.randrange(1, 8 * S) for _ in range(count))]
