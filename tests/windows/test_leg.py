"""The leg ends in its time whatever Wine does, says what it left out, and fails only for what failed."""

import pytest

from tests.windows import leg


class Pieces:
    """A piece that takes some seconds of a clock and ends with the given codes, one after the other."""

    def __init__(self, now, name, seconds, *codes):
        self.now, self.name, self.seconds, self.codes, self.runs = now, name, seconds, list(codes), []

    def run(self, seconds, again):
        self.runs.append(again)
        self.now[0] += min(seconds, self.seconds)
        return leg.TOO_LONG if self.seconds > seconds else self.codes.pop(0)


@pytest.fixture
def now():
    """What the clock shows, in a list."""
    return [5000.0]


@pytest.fixture
def run(now):
    """Runs a leg of 900 s; its exit code, its seconds and what it said."""

    def run(*pieces, set_up=lambda _: 0):
        said = []
        code = leg.Leg(900.0, lambda: now[0], said.append).run(set_up, list(pieces))
        return code, now[0] - 5000.0, "\n".join(said)

    return run


def test_all_pieces_run_where_there_is_time(run, now):
    code, seconds, said = run(Pieces(now, "core", 100, 0), Pieces(now, "cli", 200, 0))
    assert (code, seconds) == (0, 300) and "2 of 2 pieces passed in 300 s: core, cli." in said and "LEFT OUT" not in said


def test_nothing_is_begun_near_the_end_and_that_is_said(run, now):
    late = Pieces(now, "cli", 1, 0)
    code, _, said = run(Pieces(now, "core", 850, 0), late)
    assert (code, late.runs) == (0, []) and "LEFT OUT, for there was no time: cli." in said


def test_a_piece_that_does_not_end_is_ended_in_time_and_told_as_left_out(run, now):
    code, seconds, said = run(Pieces(now, "core", 10000))
    assert (code, seconds) == (0, 890) and "LEFT OUT, for there was no time: core." in said


def test_what_fails_once_and_then_passes_has_passed(run, now):
    shaky = Pieces(now, "core", 100, 1, 0)
    code, _, said = run(shaky)
    assert (code, shaky.runs) == (0, [False, True]) and "core: exit code 1" in said


@pytest.mark.parametrize("seconds", [100, 850])
def test_what_fails_fails_the_leg_also_where_there_is_no_time_to_try_again(run, now, seconds):
    code, _, said = run(Pieces(now, "core", seconds, 1, 1), Pieces(now, "cli", 1, 0))
    assert code == 1 and "FAILED: core." in said


def test_a_set_up_that_takes_too_long_is_told_and_fails_nothing(run, now):
    given = []
    code, _, said = run(Pieces(now, "core", 1, 0), set_up=lambda seconds: given.append(seconds) or leg.TOO_LONG)
    assert (code, given) == (0, [600]) and said.startswith("SKIPPED")


def test_where_ci_has_little_time_left_the_leg_is_skipped_loudly(capsys):
    assert leg.main(250.0) == 0
    assert "Windows: SKIPPED, for 250 s are left to CI" in capsys.readouterr().out
