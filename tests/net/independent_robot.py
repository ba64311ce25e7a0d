"""A robot by zenoh-ros2-sdk, which shares no line with coursekit, in its own environment: `independent_robot.py PORT HASH`.

It answers on /add, repeats on /echo what it hears on /words, and asks /multiply when it hears the word "ask". With an
empty HASH it names the types by hashes that it computes, as newer ROS does; Humble's is a word.
"""

import sys

from zenoh_ros2_sdk import ROS2Publisher, ROS2ServiceClient, ROS2ServiceServer, ROS2Subscriber

PORT, HASH = int(sys.argv[1]), sys.argv[2] or None
STRING = ("std_msgs/msg/String", "string data")
ADD = ("example_interfaces/srv/AddTwoInts", "int64 a\nint64 b", "int64 sum")


def arguments(name):
    """What all ends have in common."""
    return {"node_name": name, "domain_id": 0, "router_port": PORT, "type_hash": HASH}


def service(name):
    """What both ends of a service have in common."""
    definitions = {"request_definition": ADD[1], "response_definition": ADD[2]}
    return {"srv_type": ADD[0], **definitions, **arguments(name)}


def main():
    """Be there until stdin ends."""
    echo = ROS2Publisher("/echo", STRING[0], STRING[1], **arguments("echoer"))
    client = ROS2ServiceClient("/multiply", timeout=20.0, **service("asker"))

    def hear(message):
        if message.data != "ask":
            echo.publish(data=f"heard {message.data}")
        else:
            client.call_async(lambda response: echo.publish(data=f"product {response.sum}"), a=6, b=7)

    ROS2Subscriber("/words", STRING[0], hear, STRING[1], **arguments("hearer"))
    server = ROS2ServiceServer("/add", callback=lambda request: server.response_msg_class(sum=request.a + request.b),
                               **service("adder"))  # fmt: skip
    print("there", flush=True)
    sys.stdin.read()


main()
