"""Compiled programs: ros2_control's handles, loans, descriptions and semantic components."""

from __future__ import annotations

from coursekit.processes.executables import make_process
from tests.nodes.compiled.conftest import program

ROBOT = """<robot name="r"><ros2_control name="arm" type="system">
<hardware><plugin>a/Arm</plugin><param name="port">/dev/arm</param></hardware>
<gpio name="lamp"><command_interface name="on" data_type="bool" size="2"/></gpio>
<joint name="elbow"><command_interface name="position"/>
<state_interface name="position"/><state_interface name="velocity"/></joint>
<transmission name="gear"><plugin>transmission_interface/SimpleTransmission</plugin>
<actuator name="motor" role="first"><offset>0.25</offset></actuator>
<joint name="elbow" role="main"><mechanical_reduction>50</mechanical_reduction></joint></transmission>
</ros2_control></robot>"""


def test_the_names_do_what_they_say(session, build):
    path = build("interfaces", program("interfaces.cpp"))
    process = session.launch(make_process(session, path, [ROBOT], name="interfaces"))
    assert process.wait(20.0) == 0, process.output
    assert process.output.splitlines() == [
        "wheel/velocity wheel velocity 2.5",
        "given back",
        "10",
        "failed. value_ptr_ is null.",
        "11 4 5 10",
        "10 nan 2",
        "11 3",
        "arm system a/Arm /dev/arm bool 2",
        "gear transmission_interface/SimpleTransmission main 50 motor 0.25",
        "position position velocity",
        "no description",
        "0.510active0",
        "Failed converting string to real number",
    ]


def test_transmissions_map_both_ways(session, build):
    path = build("transmissions", program("transmissions.cpp"))
    process = session.launch(make_process(session, path, [ROBOT], name="transmissions"))
    assert process.wait(20.0) == 0, process.output
    lines = process.output.splitlines()
    told = [line for line in lines if line.startswith("[ERROR]")]  # not by the way of what is printed: before it or after
    assert [line for line in lines if line not in told] == [
        "simple 2.25 4 150 back 100 200 3",
        "differential 5.5 0.5 3.5 0.125 40 -80 back 20 40 2 3",
        "linkage 6 -1.5 5 -5 32 -1 back 40 10 2 3",
        "No joint handles were passed in",
        "There should be exactly two unique joint names but was given '[ elbow ]'.",
        "Not enough valid or required actuator position handles were presented.",
        "None of the provided handles are valid or from the required interfaces.",
        "Transmission reduction ratio cannot be zero.",
        "Reduction and offset vectors must have size 2.",
        "gear 3.25",
        "1",
    ]
    assert told == [
        "[ERROR] [1700000000.000000000] [simple_transmission_loader]: Failed to construct transmission "
        "'Transmission reduction ratio cannot be zero.'",
    ]
