"""Actions and substitutions that a program adds to XML and YAML."""

from __future__ import annotations

import io
from typing import Any

import pytest
from launch import Action
from launch.frontend import Entity, Parser, expose_action, expose_substitution
from launch.substitution import Substitution


def test_programs_can_expose_actions_and_substitutions_of_their_own(launch) -> None:
    @expose_action("test_shout")
    class Shout(Action):
        def __init__(self, what: Any) -> None:
            super().__init__()
            self.what = what

        @classmethod
        def parse(cls, entity: Entity, parser: Parser) -> Any:
            return cls, {"what": parser.parse_substitution(entity.get_attr("what"))}

        def execute(self, context: Any) -> Any:
            from launch.actions import LogInfo

            return [LogInfo(msg=[*self.what, "!"])]

    @expose_substitution("test-upper")
    class Upper(Substitution):
        def __init__(self, text: Any) -> None:
            self.text_parts = text

        @classmethod
        def parse(cls, data: Any) -> Any:
            return cls, {"text": data[0]}

        def perform(self, context: Any) -> str:
            return "".join(part.perform(context) for part in self.text_parts).upper()

    root, parser = Parser.load(io.StringIO('<launch><test_shout what="$(test-upper hey)"/></launch>'))
    assert launch([parser.parse_description(root)]).lines == ["[INFO] [launch.user]: HEY!"]
    with pytest.raises(RuntimeError, match="is not a callable or a class containing a parse method"):
        expose_action("x")(3)
    with pytest.raises(RuntimeError, match="Not recognized frontend implementation"):
        Parser.get_parser_from_extension("toml")
