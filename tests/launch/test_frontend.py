from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import pytest
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.frontend import Parser
from launch.launch_description_sources import (
    AnyLaunchDescriptionSource,
    FrontendLaunchDescriptionSource,
    XMLLaunchDescriptionSource,
    YAMLLaunchDescriptionSource,
)

from tests.needs import slashed

USER = "[INFO] [launch.user]: "

SHOW = (
    'import os, sys\nprint("ARGV", " ".join(sys.argv[1:]), "ENV", os.environ.get("A"), os.environ.get("B"))\n'
)


def read(text: str) -> LaunchDescription:
    root, parser = Parser.load(io.StringIO(text))
    return parser.parse_description(root)


def both(xml: str, yaml: str) -> Any:
    return pytest.mark.parametrize(
        "text", [f"<launch>{xml}</launch>", "launch:\n" + yaml], ids=["xml", "yaml"]
    )


@both(
    """
  <arg name="who" default="you" description="whom to greet"><choice value="you"/><choice value="me"/></arg>
  <let name="greeting" value="hello $(var who)"/>
  <log message="$(var greeting)"/>
  <log message="no" if="$(equals $(var who) me)"/>
  <log message="unless" unless="false"/>
  <unset name="greeting"/>
  <log message="$(var greeting gone)"/>
""",
    """
- arg: {name: who, default: you, description: whom to greet, choice: [{value: you}, {value: me}]}
- let: {name: greeting, value: hello $(var who)}
- log: {message: $(var greeting)}
- log: {message: "no", if: $(equals $(var who) me)}
- log: {message: unless, unless: "false"}
- unset: {name: greeting}
- log: {message: $(var greeting gone)}
""",
)
def test_arguments_configurations_and_conditions(launch, text: str) -> None:
    assert launch([read(text)]).lines == [USER + "hello you", USER + "unless", USER + "gone"]


@both(
    """
  <let name="a" value="1"/>
  <group>
    <let name="a" value="2"/>
    <set_env name="A" value="x"/>
    <append_env name="A" value="y" separator="-"/>
    <log message="$(var a) $(env A)"/>
  </group>
  <group scoped="false"><let name="b" value="3"/></group>
  <group forwarding="false"><keep name="k" value="$(var a)"/><log message="$(var a none) $(var k)"/></group>
  <log message="$(var a) $(var b) $(env A unset)"/>
  <set_env name="A" value="z"/><unset_env name="A"/>
  <log message="$(env A 'not set')"/>
""",
    """
- let: {name: a, value: "1"}
- group:
  - let: {name: a, value: "2"}
  - set_env: {name: A, value: x}
  - append_env: {name: A, value: y, separator: "-"}
  - log: {message: $(var a) $(env A)}
- group: {scoped: false, children: [let: {name: b, value: "3"}]}
- group:
    forwarding: false
    children:
    - keep: {name: k, value: $(var a)}
    - log: {message: $(var a none) $(var k)}
- log: {message: $(var a) $(var b) $(env A unset)}
- set_env: {name: A, value: z}
- unset_env: {name: A}
- log: {message: $(env A 'not set')}
""",
)
def test_groups_scope_configurations_and_environment(
    launch, text: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("A", raising=False)
    assert launch([read(text)]).lines == [
        USER + "2 x-y",
        USER + "none 1",
        USER + "1 3 unset",
        USER + "not set",
    ]


@both(
    """
  <timer period="2.5"><log message="later"/></timer>
  <executable cmd="true" respawn="false" shell="false" sigterm_timeout="1.0"/>
  <executable cmd="echo 'two  words' $(eval '1 + 1') end" output="screen" name="say" on_exit="shutdown"/>
""",
    """
- timer: {period: 2.5, children: [log: {message: later}]}
- executable: {cmd: "true", respawn: false, shell: false, sigterm_timeout: 1.0}
- executable: {cmd: "echo 'two  words' $(eval '1 + 1') end", output: screen, name: say, on_exit: shutdown}
""",
)
def test_timers_and_executables(launch, text: str) -> None:
    lines = launch([read(text)]).lines
    assert "[say-2] two  words 2 end" in lines
    assert USER + "later" not in lines
    assert "[INFO] [launch]: process[say-2] was required: shutting down launched system" in lines


@both(
    """
  <set_parameter name="everywhere" value="7"/>
  <set_remap from="old" to="new"/>
  <group>
    <push-ros-namespace namespace="robot1"/>
    <node pkg="demo" exec="show" name="tom" namespace="ns" output="screen"
          args="-x 'a b'" ros_args="--log-level info">
      <param name="speed" value="1.5"/>
      <param name="label" value="1" type="str"/>
      <param name="list" value="1,2,3" value-sep=","/>
      <param name="camera"><param name="width" value="640"/><param name="on" value="$(var on)"/></param>
      <param from="$(var folder)/p.yaml"/>
      <remap from="a" to="b"/>
      <env name="A" value="1"/>
      <env name="B" value="$(var on)"/>
    </node>
  </group>
""",
    """
- set_parameter: {name: everywhere, value: 7}
- set_remap: {from: old, to: new}
- group:
  - push_ros_namespace: {namespace: robot1}
  - node:
      pkg: demo
      exec: show
      name: tom
      namespace: ns
      output: screen
      args: -x 'a b'
      ros_args: --log-level info
      param:
      - {name: speed, value: 1.5}
      - {name: label, value: "1", type: str}
      - {name: list, value: [1, 2, 3]}
      - {name: camera, param: [{name: width, value: 640}, {name: "on", value: $(var on)}]}
      - {from: $(var folder)/p.yaml}
      remap: [{from: a, to: b}]
      env: [{name: A, value: "1"}, {name: B, value: $(var on)}]
""",
)
def test_nodes_with_all_that_can_be_in_them(launch, workspace, text: str, tmp_path: Path) -> None:
    from launch.actions import SetLaunchConfiguration

    workspace.executable(
        "demo",
        "show",
        SHOW + "import re\n"
        'for path in re.findall(r"--params-file (\\S*launch_params_\\S+)", " ".join(sys.argv)):\n'
        '    print("FILE", " ".join(open(path).read().split()))\n',
    )
    (tmp_path / "p.yaml").write_text("/**: {ros__parameters: {a: 1}}")
    lines = launch(
        [SetLaunchConfiguration("on", "true"), SetLaunchConfiguration("folder", str(tmp_path)), read(text)]
    ).lines
    argv = next(line for line in lines if "ARGV" in line)
    assert argv.startswith(
        "[show-1] ARGV -x a b --ros-args --log-level info --ros-args -r __node:=tom "
        "-r __ns:=/robot1/ns -p everywhere:=7 --params-file "
    )
    assert slashed(argv).endswith(f"--params-file {slashed(tmp_path)}/p.yaml -r old:=new -r a:=b ENV 1 true")
    files = [line.split("FILE ")[1] for line in lines if "FILE" in line]
    assert files == [
        f"/robot1/ns/tom: ros__parameters: {text}"
        for text in ("speed: 1.5", "label: '1'", "list: - 1 - 2 - 3", "camera.on: true camera.width: 640")
    ]


@both(
    """
  <include file="$(dirname)/inner.launch.xml"><arg name="a" value="from outside"/></include>
  <log message="back in $(filename)"/>
""",
    """
- include: {file: $(dirname)/inner.launch.xml, arg: [{name: a, value: from outside}]}
- log: {message: back in $(filename)}
""",
)
def test_includes_know_where_they_are(launch, text: str, tmp_path: Path) -> None:
    outer = tmp_path / ("outer.launch.xml" if text.startswith("<") else "outer.launch.yaml")
    outer.write_text(text)
    (tmp_path / "inner.launch.xml").write_text(
        '<launch><arg name="a"/><log message="$(var a) in $(filename)"/></launch>'
    )
    said = launch([IncludeLaunchDescription(AnyLaunchDescriptionSource(str(outer)))]).lines
    assert [slashed(line) for line in said] == [
        USER + f"from outside in {slashed(tmp_path)}/inner.launch.xml",
        USER + f"back in {slashed(outer)}",
    ]


def test_a_whole_xml_launch_file_runs_nodes(launch, talker) -> None:
    path = talker.file(
        "demo",
        "launch/talk.launch.xml",
        """<launch>
      <arg name="text" default="hello"/>
      <group>
        <push_ros_namespace namespace="robot1"/>
        <node pkg="demo" exec="talker" name="tom" output="screen">
          <param name="text" value="$(var text)"/></node>
      </group></launch>""",
    )
    result = launch(
        [
            IncludeLaunchDescription(
                XMLLaunchDescriptionSource(str(path)), launch_arguments={"text": "off"}.items()
            )
        ],
        interrupt_after=1.5,
    )
    assert "Caught exception" not in result.text or "off" in result.text
    result = launch([IncludeLaunchDescription(XMLLaunchDescriptionSource(str(path)))], interrupt_after=1.5)
    assert '[robot1.tom]: Publishing: "hello 0" on /robot1/chatter' in result.text


def test_shares_of_packages_can_be_named(launch, workspace) -> None:
    workspace.file("demo", "launch/inner.launch.yaml", "launch:\n- log: {message: inner}\n")
    text = (
        '<launch><include file="$(find-pkg-share demo)/launch/inner.launch.yaml"/>'
        '<log message="$(find-pkg-prefix demo)"/></launch>'
    )
    assert launch([read(text)]).lines == [USER + "inner", USER + str(workspace.prefix)]


def test_lifecycle_and_sim_time_elements_are_known() -> None:
    names = [
        type(entity).__name__
        for entity in read(
            '<launch><set_use_sim_time value="true"/><lifecycle_node pkg="a" exec="b" name="c" namespace=""/>'
            '<ros_timer period="1.0"><log message="x"/></ros_timer><set_ros_log_dir log_dir="/x"/>'
            '<node_container name="c" namespace="" pkg="p" exec="e">'
            '<composable_node pkg="a" plugin="a::B" name="n">'
            '<param name="x" value="1"/><remap from="a" to="b"/></composable_node></node_container>'
            '<shutdown reason="done"/></launch>'
        ).entities
    ]
    assert names == [
        "SetUseSimTime",
        "LifecycleNode",
        "ROSTimer",
        "SetROSLogDir",
        "ComposableNodeContainer",
        "Shutdown",
    ]


def test_sources_tell_their_location_and_method(tmp_path: Path) -> None:
    for source, method in (
        (FrontendLaunchDescriptionSource("a"), "interpreted frontend launch file"),
        (XMLLaunchDescriptionSource("a"), "interpreted XML launch file"),
        (YAMLLaunchDescriptionSource("a"), "interpreted YAML launch file"),
    ):
        assert (source.method, source.describe_location()) == (method, "'a'")
        assert "launch.substitutions.text_substitution.TextSubstitution" in source.location
