"""Trees of a package in C++ with BehaviorTree.CPP's names: what they tick, halt, remember and refuse."""

from __future__ import annotations

import re
import shlex
import shutil

import pytest

from tests.needs import compiler_or_skip
from tests.packages.bt_cases import CONTROLS, DECORATORS, ERRORS, leaf, node, shows, trees, whole
from tests.packages.pip_tools import loading_tools_or_skip
from tests.packages.test_cpp_workspace import SOURCES, colcon, scripted, sourced

pytestmark = [pytest.mark.slow, pytest.mark.timeout(900)]


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    compiler_or_skip()
    folder = tmp_path_factory.mktemp("bt_ws")
    shutil.copytree(SOURCES.parent.parent / "bt_ws" / "src", folder / "src")
    built = colcon(folder, "build")
    assert built.returncode == 0 and "3 packages finished" in built.stdout, built.stdout + built.stderr
    assert "stderr" not in built.stdout + built.stderr and "Skipped" not in built.stdout
    return folder


def ticked(workspace, cases):
    """What happens in trees, by their names: at each tick and its status, and when they are halted at last.

    A case is a tree, how often it is ticked, and how many milliseconds are between. `a+` began, `a.` went on,
    `a!` was halted, `a?` was asked, `a` was done at once.
    """
    words = [str(word) for tree, ticks, pause in cases.values() for word in (whole(tree), ticks, pause)]
    done = sourced(workspace, f"ros2 run k_trees tick {shlex.join(words)}")
    parts = re.findall(r"(?:.*\n)*?.*(?:the end|error: .*)\n", done.stdout)
    assert len(parts) == len(cases), done.stdout + done.stderr
    return {name: part.splitlines() for name, part in zip(cases, parts, strict=True)}


def ticked_once(workspace, tree):
    """What happens in one tick."""
    return ticked(workspace, {"tree": (tree, 1, 0)})["tree"][0]


def said(workspace, part):
    """What a part of the program `api` prints."""
    done = sourced(workspace, f"ros2 run k_trees api {part}")
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout.splitlines()


def test_control_nodes_tick_as_they_do_on_a_robot(workspace):
    found = ticked(workspace, {name: (tree, ticks, 0) for name, (tree, ticks, _) in CONTROLS.items()})
    assert {name: lines[:-1] for name, lines in found.items()} == {name: lines for name, (_, _, lines) in CONTROLS.items()}


def test_decorators_tick_as_they_do_on_a_robot(workspace):
    found = ticked(workspace, {name: (tree, ticks, 0) for name, (tree, ticks, _) in DECORATORS.items()})
    assert {name: lines[:-1] for name, lines in found.items()} == {name: lines for name, (_, _, lines) in DECORATORS.items()}


def test_a_tree_that_goes_halts_what_runs(workspace):
    tree = node("Sequence", leaf("Do", "a"), node("Inverter", leaf("Act", "b", "R")), leaf("Act", "c", "R"))
    assert ticked(workspace, {"tree": (tree, 1, 0)})["tree"] == ["a b+ RUNNING", "b! the end"]


def test_time_is_that_of_the_session(workspace):
    cases = {
        "too long": (node("Timeout", leaf("Act", "a", "R"), msec=250), 4, 100),
        "in time": (node("Timeout", leaf("Act", "a", "RRS"), msec=250), 3, 100),
        "later": (node("Delay", leaf("Act", "a", "RS"), delay_msec=150), 4, 100),
    }
    assert ticked(workspace, cases) == {
        "too long": ["a+ RUNNING", "a. RUNNING", "a. RUNNING", "a! FAILURE", "the end"],
        "in time": ["a+ RUNNING", "a. RUNNING", "a. SUCCESS", "the end"],
        "later": ["RUNNING", "RUNNING", "a+ RUNNING", "a. SUCCESS", "the end"],
    }


def test_an_action_in_a_thread_of_its_own_works_while_the_tree_is_ticked(workspace):
    cases = {
        "done": (node("Work", name="dig", steps=5), 4, 20),
        "halted": (node("ReactiveSequence", leaf("Ask", "safe", "SSF"), node("Work", name="dig", steps=500)), 3, 20),
        "left": (node("Work", name="dig", steps=500), 1, 20),
        "thrown": (node("Work", name="dig", steps=-1), 2, 20),
    }
    assert ticked(workspace, cases) == {
        "done": ["RUNNING", "RUNNING", "RUNNING", "dig= SUCCESS", "the end"],
        "halted": ["safe? RUNNING", "safe? RUNNING", "safe? dig! FAILURE", "the end"],
        "left": ["RUNNING", "dig! the end"],
        "thrown": ["RUNNING", "error: dig cannot work backwards"],
    }


def test_a_coroutine_goes_on_where_it_stopped_and_is_left_when_halted(workspace):
    found = ticked(workspace, {"tree": (node("Talk", name="t", words=2), 4, 0)})["tree"]
    assert found == ["t0 RUNNING", "t1 RUNNING", "t- SUCCESS", "t0 RUNNING", "t! t- the end"]


def test_ports_are_read_written_and_remapped(workspace):
    tree = node(
        "Sequence", node("Go", to="1;2", far="{d}", count="{n}"), node("SetBlackboard", output_key="p", value="5;6"),
        node("Go", to="{p}", far="${d}", count="{n}", gear="fast"), node("Show", what="{d}"), node("Show", what="{n}"),
        node("Show", what="as it is"), node("Show", what="{other}"), node("Show"),
    )  # fmt: skip
    assert ticked_once(workspace, tree) == (
        "to 1 to 5 fast '11.000000' '2' 'as it is' (getInput() failed because it was unable to find the key [what] "
        "remapped to [other]) (getInput() failed because NodeConfiguration::input_ports does not contain the key: [what]) "
        "SUCCESS"
    )


def test_a_subtree_has_a_blackboard_of_its_own_and_the_ports_that_are_named(workspace):
    inner = node("Sequence", shows("in", "out"), node("SetBlackboard", output_key="out", value="back"))
    put = node("SetBlackboard", output_key="x", value="given") + node("SetBlackboard", output_key="out", value="mine")

    def of(kind, **ports):
        return trees(node("Sequence", put, node(kind, ID="Inner", **ports), shows("out", "y")), Inner=inner), 1, 0

    cases = {
        "'given' - 'mine' 'back'": of("SubTree", **{"in": "x", "out": "y"}),
        "- - 'mine' -": of("SubTree"),
        "- 'mine' 'back' -": of("SubTree", __shared_blackboard="true"),
        "'plain' - 'mine' 'back'": of("SubTreePlus", **{"in": "plain", "out": "{y}"}),
        "'given' 'mine' 'back' -": of("SubTreePlus", __autoremap="1", **{"in": "{x}"}),
    }
    found = ticked(workspace, cases)
    shown = {name: re.sub(r"\(getInput[^)]*\)[^)]*\)", "-", lines[0]) for name, lines in found.items()}
    assert shown == {name: f"{name} SUCCESS" for name in cases}


def test_both_forms_of_a_node_are_the_same(workspace):
    tree = node("Control", node("Action", ID="Do", name="a"), leaf("Do", "b"), node("Condition", ID="Ask"), ID="Sequence")
    assert ticked_once(workspace, node("Decorator", tree, ID="Inverter")) == "a b Ask? FAILURE"


def test_a_tree_that_is_wrong_is_told_so(workspace):
    found = ticked(workspace, {tree: (tree, 1, 0) for tree in ERRORS})
    assert {tree: lines[-1].partition("error: ")[2] for tree, lines in found.items()} == ERRORS


def test_all_of_xml_is_read(workspace):
    text = """<root><?a b?><!-- <c> --><BehaviorTree ID='Main'>
      <Sequence> text <Show what="&lt;&#65;&#xe9;&amp;b&quot;" /><!-- - --><Show
        what='a "b" > c'/></Sequence ></BehaviorTree></root>"""
    assert ticked_once(workspace, text) == "'<Aé&b\"' 'a \"b\" > c' SUCCESS"


def test_texts_become_values_and_back(workspace):
    assert said(workspace, "texts") == [
        "RUNNING SubTree InOut", "\x1b[32mSUCCESS\x1b[0m\x1b[31mFAILURE\x1b[0m", "4 2.5 1 IDLE 4",
        "RuntimeError: convertFromString(): invalid bool conversion",
        "RuntimeError: Cannot convert this to NodeStatus: DONE",
        "LogicError: You didn't implement the template specialization of convertFromString for this type: "
        "std::map<int, int, std::less<int>, std::allocator<std::pair<int const, int> > >",
        "exception: A port can not use a reserved name. See ReservedPortNames",
    ]  # fmt: skip


def test_values_come_out_as_other_types_where_nothing_is_lost(workspace):
    assert said(workspace, "values") == [
        "7 7 0.5 seven std::string 1", "exception: Floating point truncated",
        "exception: Value outside the numerical limits.",
        "exception: Implicit casting to bool is not allowed",
        "exception: [Any::convert]: no known safe conversion between [std::string] and [int]",
        "exception: Any::cast failed because it is empty",
    ]  # fmt: skip


def test_a_blackboard_keeps_types_and_shares_keys(workspace):
    assert said(workspace, "board") == [
        "5 15 0", "2", "RuntimeError: Blackboard::get() error. Missing key [nowhere]", "place (k_trees::Place) -> full",
        "out (int) -> full",
        "LogicError: Blackboard::set() failed: once declared, the type of a port shall not change. Declared type "
        "[k_trees::Place] != current type [double]",
    ]  # fmt: skip


def test_a_factory_knows_its_nodes_and_trees(workspace):
    lines = said(workspace, "factory")
    assert lines.pop(9).startswith("RuntimeError: Could not load library libnot_there.so: ")
    assert lines == [
        "BehaviorTreeException: ID [Hello] already registered",
        "LogicError: You can not remove the builtin registration ID [Sequence]", "10", "Main", "Second",
        "Spot has 4 legs", "SUCCESS", "exception: Can't find a tree with name: Third",
        "RuntimeError: BehaviorTreeFactory: ID [Never] not registered",
        "<root>", "    <TreeNodesModel>", '        <Action ID="Hello">',
        '            <input_port name="to" type="std::string">who is greeted</input_port>', "        </Action>",
        '        <Action ID="Robot"/>', '        <Decorator ID="Twice"/>', "    </TreeNodesModel>", "</root>",
    ]  # fmt: skip


def test_a_tree_is_printed_visited_heard_and_overridden(workspace):
    line = "----------------"
    assert said(workspace, "trees") == [
        line, "all", "   hi", "   Inverter", "      Twice", "         no", line, "5 5 Hello", "all: IDLE RUNNING",
        "hello you",
        "all: RUNNING SUCCESS", "all: SUCCESS IDLE", "SUCCESS", "FAILURE",
    ]  # fmt: skip


def test_changes_of_status_are_printed_in_colours(workspace):
    first, *lines = said(workspace, "logger")
    assert first == "LogicError: Only one instance of StdCoutLogger shall be created"
    plain = [re.sub(r"\x1b\[\d+m|^\[\d+\.\d{3}\]: ", "", line) for line in lines if line != "hello you"]
    changes = [("all", "IDLE -> RUNNING"), ("hi", "IDLE -> RUNNING"), ("hi", "RUNNING -> SUCCESS")]
    assert plain[:3] == [f"{name:25} {change}" for name, change in changes]
    assert "\x1b[33mRUNNING\x1b[0m -> \x1b[32mSUCCESS\x1b[0m" in lines[-1]
    assert lines[0].startswith("[1700000000.")


def test_a_sleeping_tree_is_woken(workspace):
    assert said(workspace, "sleep") == ["200", "300"]


def test_a_node_ticks_a_tree_with_the_nodes_of_a_library(workspace):
    loading_tools_or_skip("this computer's tools", workspace)
    done = sourced(workspace, "ros2 run k_trees patrol")
    assert done.stdout == "stopped with 25 m to go\n"
    assert re.findall(r"17(\d+\.\d)\d+\] \[patrol\]: (.*)", done.stderr) == [
        ("00000000.4", "at the door"), ("00000001.0", "20.000000"), ("00000001.5", "100"), ("00000001.5", "over"),
    ]  # fmt: skip


MISSIONS = """
from coursekit.processes.executables import find, make_process
from coursekit.processes.session import Session

with (session := Session(virtual=True)).use():
    def start(name, *words):
        return session.launch(make_process(session, find("k_missions", name), words, name=name))
    dock = start("dock")
    mission = start("mission", *{trees})
    print(mission.wait(60.0), mission.output)
    print(dock.output)
    dock.interrupt()
"""


def test_nodes_of_nav2_have_servers_work(workspace):
    dock = node("Dock", command=3)
    cases = {
        node("Sequence", node("Open", service_name="open"), dock): "opened 1; docked after 3 steps; SUCCEEDED",
        node("Open", service_name="/open", server_timeout=100): "opened 2; FAILED",
        node("Dock"): "FAILED",
        node("Dock", command="no"): "FAILED",
        node("Dock", command=-1): "FAILED",
        node("Timeout", node("Dock", command=50), msec=300): "FAILED",
        node("Parallel", node("Dock", command=50), node("Delay", node("CancelDock"), delay_msec=300), success_threshold=2): (
            "canceled; SUCCEEDED"
        ),
        node("Dock", command=50): "CANCELED",
        dock: "docked after 3 steps; SUCCEEDED",
        node("Dock", server_name="nowhere"): "error: Action server nowhere not available",
        node("Open", name="door", service_name="nowhere"): "error: Service server door not available",
    }
    trees = [whole(tree) for tree in cases]
    done = scripted(workspace, MISSIONS.format(trees=trees))
    assert done.stdout.startswith("0 "), done.stdout + done.stderr
    lines = [line for line in done.stdout.removeprefix("0 ").splitlines() if not re.match(r"\[(INFO|WARN|ERROR)\]|$", line)]
    assert lines == [*cases.values(), "1 1map30.8"], done.stdout + done.stderr
    assert done.stdout.count("asked to stop") == 3
