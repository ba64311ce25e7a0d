"""The services that control a player."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rosbag2_interfaces.srv import (
    Burst,
    GetRate,
    IsPaused,
    Pause,
    PlayNext,
    Resume,
    Seek,
    SetRate,
    TogglePaused,
)


def offer_services(player: Any) -> None:
    """Create the services under the player's name: /rosbag2_player/pause and so on."""

    def serve(kind: Any, name: str, act: Callable[[Any], Any], answer: str = "") -> None:
        def callback(request: Any, response: Any) -> Any:
            result = act(request)
            if answer:
                setattr(response, answer, result)
            return response

        player.create_service(kind, f"~/{name}", callback)

    serve(Pause, "pause", lambda _: player.pause())
    serve(Resume, "resume", lambda _: player.resume())
    serve(TogglePaused, "toggle_paused", lambda _: player.toggle_paused())
    serve(IsPaused, "is_paused", lambda _: player.clock.paused, "paused")
    serve(GetRate, "get_rate", lambda _: player.clock.rate, "rate")
    serve(SetRate, "set_rate", lambda request: player.set_rate(request.rate), "success")
    serve(PlayNext, "play_next", lambda _: player.play_next(), "success")
    serve(Burst, "burst", lambda request: player.burst(request.num_messages), "actually_burst")
    serve(Seek, "seek", lambda request: _seek(player, request.time), "success")


def _seek(player: Any, time: Any) -> bool:
    player.seek(time.sec * 10**9 + time.nanosec)
    return True
