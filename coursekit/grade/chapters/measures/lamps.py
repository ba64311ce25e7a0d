"""The lamps of chapter 5: requests for their parameters, and the answers."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import Any

from coursekit.grade.plain import field, fields, near
from coursekit.grade.verdict import Wrong

Ask = tuple[str, dict[str, Any], bool]
"""A description, the values of parameters set at once, and whether they should be accepted."""
DOUBLE, STRING = 3, 4
"""The parameter types in rcl_interfaces/msg/ParameterType."""


def no_colour(chance: Random) -> str:
    """Return a colour that the lamps do not have."""
    return chance.choice(("violet", "blue", "white", "Red", "pink"))


def calls_that_set(node: str, asks: Sequence[Ask]) -> list[tuple[float, str, str, Any]]:
    """Return one call for each request, in order, from 1.1 s on."""
    service, kind = f"{node}/set_parameters_atomically", "rcl_interfaces/srv/SetParametersAtomically"
    return [(1.1 + 0.05 * index, service, kind, _request(values)) for index, (_, values, _) in enumerate(asks)]


def _request(values: dict[str, Any]) -> dict[str, Any]:
    typed = {
        name: {"type": DOUBLE, "double_value": value}
        if isinstance(value, float)
        else {"type": STRING, "string_value": value}
        for name, value in values.items()
    }
    return {"parameters": [{"name": name, "value": value} for name, value in typed.items()]}


def judge_range(answer: Any) -> None:
    """Raise Wrong when lamp.period is described without its range."""
    wanted = "lamp.period described with a floating_point_range from 0.1 to 2.0"
    descriptor = (field(answer, "descriptors", list, wanted) or [None])[0]
    ranges = field(descriptor, "floating_point_range", list, wanted)
    if not ranges:
        cause = "The range goes into the ParameterDescriptor, the third argument of declare_parameter."
        raise Wrong(wanted, "it has none", cause, share=0.25, hint=0)
    ends = fields(ranges[0], ("from_value", "to_value"), wanted)
    if not near(ends[0], 0.1, 1e-9) or not near(ends[1], 2.0, 1e-9):
        raise Wrong(wanted, f"from {ends[0]:g} to {ends[1]:g}", share=0.25, hint=0)


def judge_answers(asks: Sequence[Ask], answers: Sequence[Any]) -> None:
    """Raise Wrong at the first request that was wrongly accepted or rejected."""
    for (told, _, taken), answer in zip(asks, answers, strict=True):
        _judge_answer(told, answer, taken)


def _judge_answer(told: str, answer: Any, taken: bool) -> None:
    if answer is None:
        cause = "Does judge return a SetParametersResult in every case?"
        raise Wrong(f"an answer to: {told}", "none", cause, share=0.25, hint=1)
    successful, reason = field(answer, "result.successful", bool), field(answer, "result.reason", str)
    if successful is not taken:
        seen = "taken" if successful else f"refused: {reason[:160]}"
        cause = "judge gets a list: every one of them counts." if "at once" in told else ""
        raise Wrong(f"{told}: {'taken' if taken else 'refused'}", seen, cause, share=0.5, hint=1)
    if not taken and "colour" in told and not reason.strip():
        cause = "SetParametersResult has a field for it."
        raise Wrong("a reason with the refused colour", "an empty one", cause, share=0.75, hint=1)
