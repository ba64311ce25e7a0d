"""`%network`: this notebook on a real ROS 2 network."""

from __future__ import annotations

import argparse
import getpass
import os
from typing import NoReturn

from IPython.core.magic import Magics, line_magic, magics_class

from coursekit.cli.session_client import domain_id
from coursekit.processes.session import current
from coursekit.systems.command_lines import split_words
from coursekit.words.gettext import gettext

from .errors import BadArgument

HELP = """%network ADDRESS [--listen-only] [--user NAME] [--certificate FILE] [--yes]
%network      who is there, what is sent and heard, how long it takes
%network off  leave"""


@magics_class
class NetworkMagics(Magics):
    """The magic for the notebook's network."""

    @line_magic
    def network(self, line: str) -> None:
        """Join a network, leave it, or report its state.

        %network tcp/robot:7447
        %network tcp/robot:7447 --listen-only    (receive, and send nothing)
        %network
        %network off
        """
        from coursekit.net.errors import NoNetwork
        from coursekit.net.joining import leave, link_of
        from coursekit.net.report import report

        words, session, domain = _words(line), current(), domain_id()
        if words.address is None:
            print(report(link_of(session, domain)))
        elif words.address == "off":
            print(gettext("Left the network.") if leave(session, domain) else gettext("No network was joined."))
        else:
            try:
                _join(words)
            except NoNetwork as error:
                print(error)
                return
            print(report(link_of(session, domain)))


def _join(words: argparse.Namespace) -> None:
    from coursekit.net.joining import credentials_from_the_environment, join
    from coursekit.net.zenoh_session import Credentials

    asked = credentials_from_the_environment()
    user = words.user or asked.user
    password = asked.password if user == asked.user else ""
    if user and not password:
        password = getpass.getpass(gettext(f"Password of {user}: "))
    credentials = Credentials(user, password, words.certificate or asked.certificate)
    sure = (lambda _moves: True) if words.yes else _confirmed
    address = words.address if words.address is not None else ""
    join(current(), domain_id(), address, credentials=credentials, listen_only=words.listen_only, confirm=sure)


def _confirmed(moves: list[str]) -> bool:
    """Ask the user for confirmation; where no input is possible, the answer is no."""
    print(gettext("This would move a robot as soon as you join:"), *(f"  {move}" for move in moves), sep="\n")
    try:
        asked = gettext("Is the robot's path clear, and somebody at its stop button? Type yes to join: ")
        return input(asked).strip().lower() == "yes"
    except (EOFError, RuntimeError, NotImplementedError):
        print(gettext("Nobody can be asked here. If you are sure: %network ADDRESS --yes"))
        return False


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise BadArgument(f"%network: {message}.\n{HELP}")


def _words(line: str) -> argparse.Namespace:
    parser = _Parser(prog="%network", add_help=False)
    parser.add_argument("address", nargs="?")
    parser.add_argument("--listen-only", action="store_true")
    parser.add_argument("--user", default="")
    parser.add_argument("--certificate", default="")
    parser.add_argument("--yes", action="store_true")
    return parser.parse_args([os.path.expandvars(word) for word in split_words(line)])


__all__ = ["NetworkMagics"]
