"""`ros2 topic list|info|type|find|echo|pub|hz|bw|delay`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from coursekit.cli import api, topic_echo, topic_pub, topic_rates

if TYPE_CHECKING:
    import argparse
    from argparse import Namespace


def register(subparsers: Any) -> None:
    """Add the command."""
    parser = subparsers.add_parser("topic", help="Various topic related sub-commands")
    api.add_hidden_flag(parser, "topics")
    verbs = parser.add_subparsers(title="Verbs", dest="_verb", required=True)
    _register_list(verbs)
    info = verbs.add_parser("info", help="Print information about a topic")
    _topic_argument(info)
    info.add_argument("-v", "--verbose", action="store_true", help="Prints detailed information like the node name, QoS")
    info.set_defaults(main=show_info)
    kind = verbs.add_parser("type", help="Print a topic's type")
    _topic_argument(kind)
    kind.set_defaults(main=show_type)
    find = verbs.add_parser("find", help="Output a list of available topics of a given type")
    find.add_argument("topic_type", help="Name of the ROS topic type to filter for").completer = (
        api.complete_interfaces("msg")
    )
    find.add_argument("-c", "--count-topics", action="store_true", help="Only display the number of topics")
    find.add_argument("--include-hidden-topics", action="store_true", dest="hidden_too", help="Hidden ones as well")
    find.set_defaults(main=find_topics)
    topic_echo.register(verbs)
    topic_pub.register(verbs)
    topic_rates.register(verbs)


def _topic_argument(parser: Any) -> None:
    parser.add_argument("topic_name", help="Name of the ROS topic (e.g. '/chatter')").completer = api.complete_topics


def _register_list(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    lister = verbs.add_parser("list", help="Output a list of available topics")
    lister.add_argument("-t", "--show-types", action="store_true", help="Additionally show the topic type")
    lister.add_argument("-c", "--count-topics", action="store_true", help="Only display the number of topics")
    lister.add_argument("--include-hidden-topics", action="store_true", dest="hidden_too", help="Hidden ones as well")
    lister.add_argument("-v", "--verbose", action="store_true", help="List full details about each topic")
    lister.set_defaults(main=list_topics)


def list_topics(args: Namespace) -> int:
    """Print the topics."""
    topics = api.topics(args.hidden or args.hidden_too)
    if args.count_topics:
        print(len(topics))
    elif args.verbose:
        _list_verbose(topics)
    else:
        for name, types in topics:
            print(f"{name} [{', '.join(types)}]" if args.show_types else name)
    return 0


def _list_verbose(topics: list[tuple[str, list[str]]]) -> None:
    graph = api.graph()
    for title, word, ends in (
        ("Published topics:", "publisher", graph.publishers),
        ("\nSubscribed topics:", "subscriber", graph.subscriptions),
    ):
        print(title)
        for name, types in topics:
            count = len(ends.get(name, ()))  # type: ignore[attr-defined]
            if count:
                print(f" * {name} [{', '.join(types)}] {count} {word}{'s' if count > 1 else ''}")
    print("")


def show_info(args: Namespace) -> int:
    """Print a topic's type and endpoints."""
    name = api.full_name(args.topic_name)
    types = dict(api.topics(hidden=True)).get(name)
    if types is None:
        api.say_error(f"Unknown topic '{args.topic_name}'")
        return 1
    gap = "\n" if args.verbose else ""
    print(f"Type: {types[0] if len(types) == 1 else types}{gap}")
    with api.command_node() as node:
        for title, infos in (
            ("Publisher", node.get_publishers_info_by_topic(name)),
            ("Subscription", node.get_subscriptions_info_by_topic(name)),
        ):
            print(f"{title} count: {len(infos)}{gap}")
            if args.verbose:
                for info in infos:
                    print(info, end="\n\n")
    return 0


def show_type(args: Namespace) -> int:
    """Print a topic's types."""
    types = dict(api.topics(args.hidden)).get(api.full_name(args.topic_name))
    for type_name in types or ():
        print(type_name)
    return 0 if types else 1


def find_topics(args: Namespace) -> int:
    """Print the topics of a type."""
    names = [name for name, types in api.topics(args.hidden or args.hidden_too) if args.topic_type in types]
    if args.count_topics:
        print(len(names))
    else:
        for name in names:
            print(name)
    return 0
