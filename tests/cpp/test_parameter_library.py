"""What the YAML files of generate_parameter_library may say, and what is said of those that are wrong."""

from __future__ import annotations

import pytest

from coursekit.packages.generate_parameters import main

WRONG = {
    "a: {}\nb: {}\n": "The yaml definition must only have one root element",
    "arm: {rate: {default_value: 1.0}}": "No type defined for parameter rate",
    "arm: {pid: {p: {description: x}}}": "No type defined for parameter pid.p",
    "arm: {pid: {p: 3}}": "No type defined for parameter pid",
    "arm: {rate: {type: float}}": "Invalid parameter type `float` for parameter rate. Allowed types are: none, bool,",
    "arm: {rate: {type: double, default: 1.0}}": "Invalid syntax in parameter rate. 'default' is not valid syntax",
    "arm: {rate: {type: double, default_value: 1}}": "Parameter rate has incorrect type. Expected: double, got: int",
    "arm: {names: {type: string_array, default_value: [a, 1]}}": "Expected: string_array, got: int",
    "arm: {rate: [": "while parsing",
    "arm: {'rate; int x': {type: int}}": "'rate; int x' cannot be a name in C++: it has letters, digits and underscores",
    "arm: {rate: {type: int, validation: gt}}": "Invalid syntax in parameter rate. 'validation' has to name checks",
    "arm: {rate: {type: int, validation: {gt<>: {a: 1}}}}": "parameter rate. gt<> cannot be given {'a': 1}",
    "arm: &a {pid: *a}": "recursion",
}


@pytest.mark.parametrize("text", WRONG)
def test_a_wrong_file_is_refused_with_what_is_wrong(text, tmp_path, capsys):
    file, header = tmp_path / "arm.yaml", tmp_path / "arm.hpp"
    file.write_text(text, encoding="utf-8")
    assert main([str(header), str(file)]) == 1
    assert capsys.readouterr().err.startswith("ERROR: ") and not header.exists()
    main([str(header), str(file)])
    assert WRONG[text] in capsys.readouterr().err


def test_a_parameter_may_be_called_type(tmp_path):
    file, header = tmp_path / "arm.yaml", tmp_path / "arm.hpp"
    file.write_text("arm: {sensor: {type: {type: string, default_value: force}}}", encoding="utf-8")
    assert main([str(header), str(file)]) == 0
    assert 'std::string type = "force";' in header.read_text(encoding="utf-8")
