"""Run by the system's Python, where Debian's python3-tf2 is: data and questions for the C++ library, as JSON lines.

With the word `time`, it prints how long lookups of chains take instead (microseconds).
"""

import json
import sys
import timeit


def message(parent, child, stamp, pose):
    """A transform of ROS 1, for that is what Debian's binding takes."""
    import genpy
    from geometry_msgs.msg import TransformStamped

    msg = TransformStamped()
    msg.header.frame_id, msg.child_frame_id = parent, child
    msg.header.stamp = genpy.Time(0, stamp)
    t, r = msg.transform.translation, msg.transform.rotation
    t.x, t.y, t.z, r.x, r.y, r.z, r.w = pose
    return msg


def filled(data):
    """A C++ buffer."""
    import tf2_py

    core = tf2_py.BufferCore()
    for parent, child, stamp, pose, static in data:
        (core.set_transform_static if static else core.set_transform)(message(parent, child, stamp, pose), "test")
    return core


def answer(core, target, source, time):
    """A lookup's numbers, or its error."""
    import genpy
    import tf2_py

    try:
        transform = core.lookup_transform_core(target, source, genpy.Time(0, time))
    except tf2_py.TransformException as error:
        return [type(error).__name__, str(error)]
    t, r = transform.transform.translation, transform.transform.rotation
    return [[t.x, t.y, t.z, r.x, r.y, r.z, r.w], transform.header.stamp.to_nsec()]


def duration(core, target, source, time):
    """Microseconds that a lookup takes."""
    import genpy

    stamp = genpy.Time(0, time)
    runs = timeit.repeat(lambda: core.lookup_transform_core(target, source, stamp), number=5000, repeat=5)
    return min(runs) / 5000 * 1e6


def main():
    """Answer each line of the input."""
    answer_with = duration if "time" in sys.argv else answer
    for line in sys.stdin:
        job = json.loads(line)
        core = filled(job["data"])
        print(json.dumps([answer_with(core, *question) for question in job["questions"]]), flush=True)


if __name__ == "__main__":
    main()
