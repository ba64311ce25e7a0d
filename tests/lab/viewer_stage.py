"""What viewers are shown, and what they make of it."""

from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import LaserScan

from coursekit.lab.viewer import viewer


def frame(node, parent, child, x=0.0, static=True):
    from tf2_ros import StaticTransformBroadcaster, TransformBroadcaster

    msg = TransformStamped(child_frame_id=child)
    msg.header.frame_id, msg.header.stamp = parent, node.get_clock().now().to_msg()
    msg.transform.translation.x = x
    (StaticTransformBroadcaster if static else TransformBroadcaster)(node).sendTransform(msg)


def said(node, type_, topic, frame_id="map", **fields):
    msg = type_(**fields)
    if hasattr(msg, "header"):
        msg.header.frame_id = frame_id
    node.create_publisher(type_, topic, 1).publish(msg)
    return msg


def scan(node, **fields):
    return said(node, LaserScan, "/scan", ranges=[1.0, 2.0], angle_increment=0.5, range_max=5.0, **fields)


def shapes(panel, name):
    key = panel.stage.find(name).key
    panel.stage.update()
    return [
        shape for (display_key, _), thing in panel.stage.scene.things.items() if display_key == key for shape in thing.shapes
    ]


def scan_of(far):
    msg = LaserScan(ranges=[far], range_max=9.0)
    msg.header.frame_id = "map"
    return msg


def show(session, talker, display, *messages):
    """What a display draws after messages, and what it says."""
    panel = viewer(fixed_frame="map", displays=[display])
    config = panel.stage.displays[0].config
    publisher = talker.create_publisher(type(messages[0]), config.topic, 10)
    for msg in messages:
        msg.header.frame_id = "map"
        publisher.publish(msg)
        session.clock.sleep(0.05)
        panel.stage.update()
    things = list(panel.stage.scene.things.values())
    return [shape for thing in things for shape in thing.shapes], panel.status(config.name), things
