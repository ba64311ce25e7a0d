"""What viewers are shown, and what they make of it."""

from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import LaserScan


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
    return [shape for (one, _), thing in panel.stage.scene.things.items() if one == key for shape in thing.shapes]
