"""Trees in BehaviorTree.CPP's XML, with what happens in them tick by tick, or what is wrong with them.

At a tick `a+` began, `a.` went on, `a!` was halted, `a?` was asked, `a` was done at once; then the tree's status.
"""

from __future__ import annotations


def whole(tree):
    """The text of a file with one tree, if it is not one already."""
    is_node = tree.startswith("<") and not tree.startswith("<roo")
    return f'<root><BehaviorTree ID="Main">{tree}</BehaviorTree></root>' if is_node else tree


def node(kind, *children, **ports):
    """The XML of a node."""
    attributes = "".join(f' {name}="{value}"' for name, value in ports.items())
    return f"<{kind}{attributes}>{''.join(children)}</{kind}>"


def leaf(kind, name, does="S"):
    """The XML of a node that does as the letters say."""
    return node(kind, name=name, does=does)


def trees(main, **others):
    """The XML of several trees; the main one is named."""
    parts = "".join(f'<BehaviorTree ID="{name}">{tree}</BehaviorTree>' for name, tree in {**others, "Main": main}.items())
    return f'<root main_tree_to_execute="Main">{parts}</root>'


def shows(*keys):
    """The XML of nodes that show what the blackboard has."""
    return "".join(node("Show", what=f"{{{key}}}") for key in keys)


CONTROLS = {
    "a sequence goes on where it was": (
        node("Sequence", leaf("Do", "a"), leaf("Act", "b", "RRS"), leaf("Do", "c")), 3,
        ["a b+ RUNNING", "b. RUNNING", "b. c SUCCESS"],
    ),
    "a sequence begins again after a failure": (
        node("Sequence", leaf("Do", "a"), leaf("Do", "b", "FS")), 2, ["a b FAILURE", "a b SUCCESS"],
    ),
    "a sequence with a star goes on with what failed": (
        node("SequenceStar", leaf("Do", "a"), leaf("Do", "b", "FS"), leaf("Do", "c")), 3,
        ["a b FAILURE", "b c SUCCESS", "a b c SUCCESS"],
    ),
    "a fallback stops at the first success": (
        node("Fallback", leaf("Do", "a", "F"), leaf("Act", "b", "RF"), leaf("Do", "c"), leaf("Do", "d")), 2,
        ["a b+ RUNNING", "b. c SUCCESS"],
    ),
    "a reactive sequence asks again, and halts what ran": (
        node("ReactiveSequence", leaf("Ask", "safe", "SSF"), leaf("Act", "go", "R")), 4,
        ["safe? go+ RUNNING", "safe? go. RUNNING", "safe? go! FAILURE", "safe? FAILURE"],
    ),
    "a child of a reactive sequence that runs halts the others": (
        node("ReactiveSequence", leaf("Act", "a", "SRS"), leaf("Act", "b", "R")), 3,
        ["a+ b+ RUNNING", "a+ b! RUNNING", "a. b+ RUNNING"],
    ),
    "a reactive fallback returns to its first child": (
        node("ReactiveFallback", leaf("Ask", "there", "FFS"), leaf("Act", "go", "R")), 3,
        ["there? go+ RUNNING", "there? go. RUNNING", "there? go! SUCCESS"],
    ),
    "two of three are enough in parallel": (
        node("Parallel", leaf("Act", "a", "RS"), leaf("Do", "b"), leaf("Act", "c", "R"), success_threshold=2), 2,
        ["a+ b c+ RUNNING", "a. c! SUCCESS"],
    ),
    "one failure ends what is parallel": (
        node("Parallel", leaf("Act", "a", "R"), leaf("Act", "b", "RF"), success_threshold=2), 2,
        ["a+ b+ RUNNING", "a. b. a! FAILURE"],
    ),
    "all must succeed in parallel, and all may fail but one": (
        node("Parallel", leaf("Do", "a", "F"), leaf("Act", "b", "RS"), success_threshold=-1, failure_threshold=-1), 1,
        ["a FAILURE"],
    ),
    "failures are as many as the threshold says": (
        node("Parallel", leaf("Do", "a", "F"), leaf("Act", "b", "RS"), success_threshold=1, failure_threshold=2), 2,
        ["a b+ RUNNING", "b. SUCCESS"],
    ),
    "if, then, and the condition is asked once": (
        node("IfThenElse", leaf("Ask", "if", "SF"), leaf("Act", "then", "RS"), leaf("Do", "else")), 3,
        ["if? then+ RUNNING", "then. SUCCESS", "if? else SUCCESS"],
    ),
    "without an else": (node("IfThenElse", leaf("Ask", "if", "F"), leaf("Do", "then")), 1, ["if? FAILURE"]),
    "while, and the condition is asked at each tick": (
        node("WhileDoElse", leaf("Ask", "while", "SF"), leaf("Act", "do", "R"), leaf("Act", "else", "RF")), 3,
        ["while? do+ RUNNING", "while? do! else+ RUNNING", "while? else. FAILURE"],
    ),
    "a case, or the last child": (
        node(
            "Sequence",
            node("Switch2", leaf("Do", "a"), leaf("Do", "b"), leaf("Do", "c"), variable="{v}", case_1="1", case_2="2"),
            node("SetBlackboard", output_key="v", value="2"),
            node("Switch2", leaf("Do", "a"), leaf("Do", "b"), leaf("Do", "c"), variable="{v}", case_1="1", case_2="2"),
        ), 1, ["c b SUCCESS"],
    ),
}  # fmt: skip
DECORATORS = {
    "inverted": (node("Inverter", leaf("Do", "a", "F")), 1, ["a SUCCESS"]),
    "forced to succeed": (node("ForceSuccess", leaf("Act", "a", "RF")), 2, ["a+ RUNNING", "a. SUCCESS"]),
    "forced to fail": (node("ForceFailure", leaf("Do", "a")), 1, ["a FAILURE"]),
    "kept running": (
        node("KeepRunningUntilFailure", leaf("Do", "a", "SSF")), 3, ["a RUNNING", "a RUNNING", "a FAILURE"],
    ),
    "repeated": (node("Repeat", leaf("Do", "a"), num_cycles=3), 2, ["a a a SUCCESS", "a a a SUCCESS"]),
    "repeated until it fails": (node("Repeat", leaf("Do", "a", "SF"), num_cycles=3), 1, ["a a FAILURE"]),
    "tried again": (
        node("RetryUntilSuccessful", leaf("Act", "a", "RFFS"), num_attempts=3), 2, ["a+ RUNNING", "a. a+ a+ SUCCESS"],
    ),
    "tried too often": (node("RetryUntilSuccesful", leaf("Do", "a", "F"), num_attempts=2), 1, ["a a FAILURE"]),
    "tried without end": (node("RetryUntilSuccessful", leaf("Do", "a", "FFFFS"), num_attempts=-1), 1, ["a a a a a SUCCESS"]),
    "checked against the blackboard": (
        node(
            "Sequence", node("SetBlackboard", output_key="n", value="7"),
            node("BlackboardCheckInt", leaf("Do", "a"), value_A="{n}", value_B="7"),
            node("BlackboardCheckString", leaf("Do", "b"), value_A="{n}", value_B="8", return_on_mismatch="SUCCESS"),
            node("BlackboardCheckInt", leaf("Do", "c"), value_A="{n}", value_B="8"),
        ), 1, ["a FAILURE"],
    ),
}  # fmt: skip
ERRORS = {
    "<Nothing/>": "Error at line 1: -> Node not recognized: Nothing",
    "<Action name='a'/>": "Error at line 1: -> The node <Action> must have the attribute [ID]",
    "<Action ID='Do'><Do/></Action>": "Error at line 1: -> The node <Action> must not have any child",
    "<Action ID='Lost'/>": "Lost is not a registered node, nor a Subtree",
    "<Sequence/>": "Error at line 1: -> A Control node must have at least 1 child",
    "<Inverter><Do/><Do/></Inverter>": "Error at line 1: -> The node <Inverter> must have exactly 1 child",
    "<Do/><Do/>": "Error at line 1: -> The node <BehaviorTree> must have exactly 1 child",
    "<SubTree ID='Lost'/>": "Can't find a tree with name: Lost",
    "<SubTree ID='Main'/>": "The tree [Main] contains itself as a subtree",
    "<Do does='X'>": "Error parsing the XML: XML_ERROR_MISMATCHED_ELEMENT, line 1: <Do> of line 1 is closed by "
    "</BehaviorTree>",
    "<Do dos='S'/>": 'Possible typo? In the XML, you tried to remap port "dos" in node [Do / Do], but the manifest of this '
    "node does not contain a port with this name.",
    "<Go to='1'/>": "missing required input [to]: a place has two numbers, not: 1",
    "<Go/>": "missing required input [to]: getInput() failed because NodeConfiguration::input_ports does not contain the "
    "key: [to]",
    "<Parallel success_threshold='2'><Do/></Parallel>": "Number of children is less than threshold. Can never succeed.",
    "<Parallel><Do/></Parallel>": "Missing parameter [success_threshold] in ParallelNode",
    "<Do does='R'/>": "SyncActionNode MUST never return RUNNING",
    "<root/>": "[main_tree_to_execute] was not specified correctly",
    "<root main_tree_to_execute='B'><BehaviorTree ID='A'><Do/></BehaviorTree></root>": "Can't find a tree with name: B",
    "<root><include/></root>": "Error at line 1: -> The node <include> must have the attribute [path]",
    "<rood/>": "The XML must have a root node called <root>",
    "nowhere/tree.xml": "Error parsing the XML: XML_ERROR_FILE_NOT_FOUND: nowhere/tree.xml",
}
