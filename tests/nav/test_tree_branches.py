"""BehaviorTree.CPP's nodes that choose, wait and remember, as workspaces' own trees have them."""

from types import SimpleNamespace

import pytest

from coursekit.nav.behavior_tree import FAILURE, RUNNING, SUCCESS, TreeError, TreeNode, read_tree
from coursekit.nav.tree_blackboard import SECONDS
from coursekit.nodes.nav2.tree_run import KINDS


class Told(TreeNode):
    """Returns what the test says, `is` or else the board's word for its name; remembers that it was halted."""

    def step(self):
        return self.get("is") or self.board[self.name]

    def stop(self):
        self.board.setdefault("halted", []).append(self.name)


@pytest.fixture
def board():
    now = SimpleNamespace(seconds=0.0)
    return {"now": now, SECONDS: lambda: now.seconds}


@pytest.fixture
def tree(board):
    def made(inner):
        return read_tree(f'<root><BehaviorTree ID="Main">{inner}</BehaviorTree></root>', {**KINDS, "Told": Told}, board)

    return made


def test_if_then_else_decides_once_and_keeps_to_it(tree, board):
    branch = tree('<IfThenElse><Told name="if"/><Told name="then"/><Told name="else"/></IfThenElse>')
    board.update({"if": SUCCESS, "then": RUNNING, "else": SUCCESS})
    assert branch.tick() == RUNNING
    board.update({"if": FAILURE, "then": FAILURE})
    assert branch.tick() == FAILURE
    assert branch.tick() == SUCCESS
    assert tree(f'<IfThenElse><Told is="{FAILURE}"/><AlwaysSuccess/></IfThenElse>').tick() == FAILURE


def test_while_do_else_decides_anew_and_halts_the_other(tree, board):
    branch = tree('<WhileDoElse><Told name="while"/><Told name="do"/><Told name="else"/></WhileDoElse>')
    board.update({"while": SUCCESS, "do": RUNNING, "else": RUNNING})
    assert branch.tick() == RUNNING and "halted" not in board
    board["while"] = FAILURE
    assert branch.tick() == RUNNING and board["halted"] == ["do"]
    with pytest.raises(TreeError, match="should have 3"):
        tree("<WhileDoElse><AlwaysSuccess/><AlwaysSuccess/></WhileDoElse>")


@pytest.mark.parametrize(("mode", "expected"), [("go", SUCCESS), ("stop", FAILURE), ("other", RUNNING)])
def test_a_switch_takes_the_case_of_its_variable(tree, board, mode, expected):
    board["mode"] = mode
    cases = f"<AlwaysSuccess/><AlwaysFailure/><Told is='{RUNNING}'/>"
    assert tree(f'<Switch2 variable="{{mode}}" case_1="go" case_2="stop">{cases}</Switch2>').tick() == expected


@pytest.mark.parametrize(
    ("ports", "states", "expected"),
    [
        ("", "srr", RUNNING),
        ("", "sss", SUCCESS),
        ("", "sfr", FAILURE),
        ('success_threshold="1"', "srr", SUCCESS),
        ('success_threshold="1" failure_threshold="2"', "frr", RUNNING),
        ('success_threshold="2" failure_threshold="3"', "ffr", FAILURE),
    ],
)
def test_parallel_counts_what_its_children_return(tree, ports, states, expected):
    words = {"s": SUCCESS, "f": FAILURE, "r": RUNNING}
    children = "".join(f'<Told is="{words[state]}"/>' for state in states)
    assert tree(f"<Parallel {ports}>{children}</Parallel>").tick() == expected


def test_parallel_ticks_no_child_again_that_has_ended(tree, board):
    branch = tree('<Parallel><Told name="fast"/><Told name="slow"/></Parallel>')
    board.update(fast=SUCCESS, slow=RUNNING)
    assert branch.tick() == RUNNING
    board.update(fast=FAILURE, slow=SUCCESS)
    assert branch.tick() == SUCCESS


def test_timeout_halts_what_takes_too_long(tree, board):
    branch = tree('<Timeout msec="1500"><Told name="drive"/></Timeout>')
    board["drive"] = RUNNING
    assert branch.tick() == RUNNING
    board["now"].seconds = 1.6
    assert branch.tick() == FAILURE and board["halted"] == ["drive"]
    assert branch.tick() == RUNNING  # from the beginning


def test_delay_waits_before_its_child(tree, board):
    branch = tree('<Delay delay_msec="500"><AlwaysSuccess/></Delay>')
    assert branch.tick() == RUNNING
    board["now"].seconds = 0.6
    assert branch.tick() == SUCCESS
    assert branch.tick() == RUNNING


def test_set_blackboard_writes_under_the_name_of_its_key(tree, board):
    board["pose"] = (1.0, 2.0)
    inner = '<SetBlackboard value="dock" output_key="mode"/><SetBlackboard value="{pose}" output_key="{goal}"/>'
    assert tree(f"<Sequence>{inner}</Sequence>").tick() == SUCCESS
    assert (board["mode"], board["goal"]) == ("dock", (1.0, 2.0))


def test_the_older_spelling_of_retry_is_known(tree):
    assert tree('<RetryUntilSuccesful num_attempts="1"><AlwaysFailure/></RetryUntilSuccesful>').tick() == FAILURE
