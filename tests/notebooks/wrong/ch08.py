"""Chapter 8."""

_MODEL = """def inverse_sensor_model(r, z):
    if r < z - {before}:
        return {free}
    if r < z + {behind}:
        return {wall}
    return {beyond}"""


def _model(*, before="0.04", behind="0.04", free="-0.4", wall="0.85", beyond="0.0"):
    return _MODEL.format(before=before, behind=behind, free=free, wall=wall, beyond=beyond)


_CAST = """def cast_ray(walls, x, y, angle, range_max=10.0):
    c, s, found = math.cos(angle), math.sin(angle), [math.inf]
    for x1, y1, x2, y2 in walls:
        dx, dy = x2 - x1, y2 - y1
        across = c * dy - s * dx
        if {parallel}:
            continue
        t = ((x1 - x) * dy - (y1 - y) * dx) / across
        part = ((x1 - x) * s - (y1 - y) * c) / across
        if {meets}:
            found.append(t)
    return {answer}"""


def _cast(*, parallel="abs(across) < 1e-12", meets="0 <= t <= range_max and 0 <= part <= 1", answer="min(found)"):
    return _CAST.format(parallel=parallel, meets=meets, answer=answer)


_EXPLORE = """from scipy import ndimage

def next_goal(cells, here):
    rows, columns = np.nonzero({where})
    if not len(rows):
        return None
    far = np.hypot(rows - here[0], columns - here[1])
    best = np.argmin(far + 1000 * (far < 3))
    return {answer}"""


def _explore(*, where="(cells == 0) & ndimage.binary_dilation(cells == -1)", answer="int(rows[best]), int(columns[best])"):
    return _EXPLORE.format(where=where, answer=answer)


WRONG = {
    "ch08.q1": [
        _model(free="0.4", wall="-0.85"),
        _model(beyond="-0.4"),
        _model(wall="3.0"),
        _model(wall="0.3"),
        _model(behind="0.3"),
        _model(before="0.005", behind="0.005"),
        _model(wall="math.nan"),
        _model(free="-math.inf"),
        "def inverse_sensor_model(r, z):\n    if r < z - 0.04:\n        return -0.4",
    ],
    "ch08.q2": [
        _cast(meets="t <= range_max and 0 <= part <= 1"),
        _cast(meets="0 <= t <= range_max"),
        _cast(meets="0 <= t and 0 <= part <= 1"),
        _cast(answer="found[-1]"),
        _cast(parallel="dx == 0"),
        _cast(answer="math.nan"),
        _cast(answer="max(found)"),
    ],
    "ch08.q3": [
        "def match(points, gap, guess):\n    return guess",
        """def match(points, gap, guess):
    steps = [0.1 * k for k in range(-3, 4)]
    tries = [(guess[0] + i, guess[1] + j, guess[2]) for i in steps for j in steps]
    return min(tries, key=lambda pose: gap(points + pose[:2]).sum())""",
        "def match(points, gap, guess):\n    return gap(points)",
        "def match(points, gap, guess):\n    return (math.nan,) * 3",
        """def match(points, gap, guess):
    for number in range(12):
        for name in ("office", "robot_world", "tec_warehouse"):
            known = Puzzle(worlds / f"{name}.yaml", number)
            if known.points.shape == points.shape and np.allclose(known.points, points):
                return known.truth
    return guess""",
    ],
    "ch08.q4": [
        _explore(where="cells == -1"),
        _explore(answer="int(columns[best]), int(rows[best])"),
        _explore(where="(cells == 0) & (np.arange(cells.shape[0])[:, None] < here[0])"),
        "def next_goal(cells, here):\n    return None",
        "def next_goal(cells, here):\n    return here",
        "def next_goal(cells, here):\n    return float('nan'), float('nan')",
    ],
}
