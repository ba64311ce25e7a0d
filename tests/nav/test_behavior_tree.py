"""Behaviour trees: how nodes steer others, and what is said of files that are no trees."""

import pytest

from coursekit.nav.behavior_tree import FAILURE, IDLE, RUNNING, SUCCESS, TreeError, TreeNode, read_tree
from coursekit.nav.tree_blackboard import STATUS_CHANGED
from coursekit.nav.tree_branches import BRANCHES
from coursekit.nav.tree_controls import CONTROLS


class Work(TreeNode):
    """Says what its port `says` tells: r, s, f, one a tick; notes itself on the board."""

    def prepare(self):
        self.told = list(self.ports["says"])

    def step(self):
        self.board["log"].append(self.name)
        return {"r": RUNNING, "s": SUCCESS, "f": FAILURE}[self.told.pop(0) if len(self.told) > 1 else self.told[0]]

    def stop(self):
        self.board["log"].append(f"stop {self.name}")


class Begins(Work):
    """Says when it begins; it goes on as it was unless it is halted, as nodes in C++ do."""

    def step(self):
        if self.status == IDLE:
            self.board["log"].append("begin")
        return super().step()


KINDS = {"Begins": Begins, **CONTROLS, "Work": Work}


def tree(inside, more=""):
    board = {"log": []}
    text = f'<root main_tree_to_execute="M"><BehaviorTree ID="M">{inside}</BehaviorTree>{more}</root>'
    return read_tree(text, KINDS, board), board["log"]


def work(name, says):
    return f'<Work name="{name}" says="{says}"/>'


def ticked(inside, count, more=""):
    root, log = tree(inside, more)
    return [root.tick() for _ in range(count)], log


@pytest.mark.parametrize(
    ("inside", "ends", "log"),
    [
        (f"<Sequence>{work('a', 's')}{work('b', 'rs')}</Sequence>", [RUNNING, SUCCESS], ["a", "b", "b"]),
        (f"<Sequence>{work('a', 'f')}{work('b', 's')}</Sequence>", [FAILURE], ["a"]),
        (f"<Fallback>{work('a', 'f')}{work('b', 's')}</Fallback>", [SUCCESS], ["a", "b"]),
        (f"<ReactiveSequence>{work('a', 's')}{work('b', 'rs')}</ReactiveSequence>", [RUNNING, SUCCESS],
         ["a", "b", "a", "b"]),
        (f"<ReactiveFallback>{work('a', 'fs')}{work('b', 'r')}</ReactiveFallback>", [RUNNING, SUCCESS],
         ["a", "b", "a", "stop b"]),
        (f"<PipelineSequence>{work('a', 'srs')}{work('b', 'rrs')}</PipelineSequence>", [RUNNING, RUNNING, SUCCESS],
         ["a", "b", "a", "b", "a", "b"]),
        (f"<RoundRobin>{work('a', 's')}{work('b', 's')}</RoundRobin>", [SUCCESS, SUCCESS, SUCCESS], ["a", "b", "a"]),
        (f"<RoundRobin>{work('a', 'f')}{work('b', 'f')}</RoundRobin>", [FAILURE], ["a", "b"]),
        (f"<RecoveryNode number_of_retries='1'>{work('a', 'fs')}{work('b', 's')}</RecoveryNode>", [SUCCESS],
         ["a", "b", "a"]),
        (f"<RecoveryNode number_of_retries='1'>{work('a', 'f')}{work('b', 's')}</RecoveryNode>", [FAILURE], ["a", "b", "a"]),
        (f"<Inverter>{work('a', 'f')}</Inverter>", [SUCCESS], ["a"]),
        (f"<RetryUntilSuccessful num_attempts='2'>{work('a', 'f')}</RetryUntilSuccessful>", [RUNNING, FAILURE], ["a", "a"]),
        (f"<SingleTrigger>{work('a', 's')}</SingleTrigger>", [SUCCESS, FAILURE], ["a"]),
    ],
)  # fmt: skip
def test_nodes_steer_their_children_as_nav2s_do(inside, ends, log):
    assert ticked(inside, len(ends)) == (ends, log)


def test_recoveries_take_turns_over_several_failures():
    recovery = f"<RoundRobin>{work('turn', 's')}{work('back', 's')}</RoundRobin>"
    _, log = ticked(f"<RecoveryNode number_of_retries='3'>{work('go', 'ffff')}{recovery}</RecoveryNode>", 1)
    assert log == ["go", "turn", "go", "back", "go", "turn", "go"]


def test_halting_stops_what_runs_and_only_that():
    root, log = tree(f"<Sequence>{work('a', 's')}{work('b', 'r')}</Sequence>")
    root.tick()
    root.halt()
    assert log == ["a", "b", "stop b"]


def test_subtrees_and_explicit_kinds_are_read():
    more = f'<BehaviorTree ID="S"><Sequence>{work("a", "s")}</Sequence></BehaviorTree>'
    inside = '<Fallback><Action ID="Work" name="b" says="f"/><SubTree ID="S" __shared_blackboard="true"/></Fallback>'
    assert ticked(inside, 1, more) == ([SUCCESS], ["b", "a"])


INNER = '<Sequence><Show key="{in}"/><Show key="{out}"/><SetBlackboard output_key="out" value="back"/></Sequence>'


@pytest.mark.parametrize(
    ("subtree", "shown", "left"),
    [  # as C++ ticks the same trees in tests/packages/test_cpp_behavior_tree.py
        ('<SubTree ID="S" in="x" out="y"/>', ["given", "-"], {"out": "mine", "y": "back"}),
        ('<SubTree ID="S"/>', ["-", "-"], {"out": "mine"}),
        ('<SubTree ID="S" __shared_blackboard="true"/>', ["-", "mine"], {"out": "back"}),
        ('<SubTreePlus ID="S" in="plain" out="{y}"/>', ["plain", "-"], {"out": "mine", "y": "back"}),
        ('<SubTreePlus ID="S" __autoremap="1" in="{x}"/>', ["given", "mine"], {"out": "back"}),
    ],
)
def test_a_subtree_has_a_blackboard_of_its_own_and_the_keys_that_are_named(subtree, shown, left):
    heard = []

    class Show(TreeNode):
        def step(self):
            heard.append(self.get("key", "-"))
            return SUCCESS

    text = f'<root main_tree_to_execute="M"><BehaviorTree ID="M">{subtree}</BehaviorTree><BehaviorTree ID="S">{INNER}'
    board = {"x": "given", "out": "mine"}
    root = read_tree(f"{text}</BehaviorTree></root>", {**CONTROLS, **BRANCHES, "Show": Show}, board)
    assert (root.tick(), heard, board) == (SUCCESS, shown, {"x": "given", **left})


DOUBLING = "".join(
    f'<BehaviorTree ID="t{n}"><Sequence><SubTree ID="t{n + 1}"/><SubTree ID="t{n + 1}"/></Sequence></BehaviorTree>'
    for n in range(30)
)
DOUBLING = f'<root>{DOUBLING}<BehaviorTree ID="t30"><AlwaysSuccess/></BehaviorTree></root>'


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("<root", "is no XML"),
        ("<tree/>", "has no <BehaviorTree"),
        ('<root main_tree_to_execute="X"><BehaviorTree ID="M"><AlwaysSuccess/></BehaviorTree></root>', "it has: M"),
        ('<root><BehaviorTree ID="M"><Dance/></BehaviorTree></root>', "a node 'Dance', which is not known here"),
        ('<root><BehaviorTree ID="M"><Inverter/></BehaviorTree></root>', "'Inverter' has 0 children; it should have 1"),
        ('<root><BehaviorTree ID="M"/></root>', "has 0 nodes at its top"),
        ('<root><BehaviorTree ID="M"><SubTree ID="M"/></BehaviorTree></root>', "does a subtree contain itself"),
        (DOUBLING, "has more than 5000 nodes"),
        ('<root><BehaviorTree ID="M"><SubTree ID="N"/></BehaviorTree></root>', "a subtree 'N', which it does not have"),
    ],
)
def test_what_is_no_tree_is_told(text, says):
    with pytest.raises(TreeError) as caught:
        read_tree(text, KINDS, {})
    assert says in str(caught.value)


@pytest.mark.parametrize(
    ("inside", "ticks", "begun"),
    [
        ("<Repeat num_cycles='3'>{}</Repeat>", 3, 3),
        ("<Inverter>{}</Inverter>", 2, 2),
        ("<RoundRobin>{}<AlwaysFailure/></RoundRobin>", 3, 3),
        ("<Sequence>{}<AlwaysSuccess/></Sequence>", 2, 2),
        ("<ReactiveSequence>{}<Work says='rrs'/></ReactiveSequence>", 3, 3),  # BehaviorTree.CPP 3.8.7
        ("<RecoveryNode number_of_retries='1'><Work says='fs'/>{}</RecoveryNode>", 2, 1),
    ],
)
def test_a_child_begins_anew_when_its_parent_says_so(inside, ticks, begun):
    _, log = ticked(inside.format("<Begins name='b' says='s'/>"), ticks)
    assert log.count("begin") == begun


def test_each_change_of_a_status_is_told_parents_first():
    root, _ = tree(f"<Sequence name='s'>{work('a', 's')}<Inverter name='i'>{work('b', 'rf')}</Inverter></Sequence>")
    changes = []
    root.board[STATUS_CHANGED] = lambda node, before, after: changes.append(f"{node.uid}{node.name} {before} {after}")
    root.tick()
    assert changes == ["1s idle running", "2a idle success", "3i idle running", "4b idle running"]
    changes.clear()
    root.tick()
    ended = ["4b running failure", "3i running success", "4b failure idle", "2a success idle", "3i success idle"]
    assert changes == [*ended, "1s running success"]
    changes.clear()
    root.halt()
    assert changes == ["1s success idle"]
