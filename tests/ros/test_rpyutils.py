"""rpyutils, as packages with compiled modules use it."""

from __future__ import annotations

import pytest
import rpyutils


def test_a_compiled_module_is_imported_by_its_name_or_beside_its_package() -> None:
    import _json
    import json.decoder

    assert rpyutils.import_c_library("_json") is _json
    assert rpyutils.import_c_library(".decoder", "json") is json.decoder


def test_a_compiled_module_that_is_not_there_says_what_to_do() -> None:
    expected = r"No module named 'json\._missing'\n\n.*'\._missing' of 'json'.*build its package"
    with pytest.raises(ImportError, match=expected):
        rpyutils.import_c_library("._missing", "json")
