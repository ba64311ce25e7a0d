"""The reader of definition files."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from coursekit.interfaces.errors import InterfaceError
from coursekit.interfaces.model import Action, FieldType, Message, Service
from coursekit.interfaces.parser import parse, parse_file


def fields(text):
    return [(f.name, str(f.type), f.default) for f in parse("pkg", "msg", "Name", text).fields]


def test_every_kind_of_field_is_read():
    text = "bool a\nstring<=5 b\nwstring c\nint8[] d\nint8[3] e\nint8[<=3] f\n"
    text += "Other g\nstd_msgs/Header[] h\nstring<=4[<=2] i"
    assert [kind for _, kind, _ in fields(text)] == [
        "bool", "string<=5", "wstring", "int8[]", "int8[3]", "int8[<=3]", "pkg/Other", "std_msgs/Header[]",
        "string<=4[<=2]",
    ]  # fmt: skip


def test_defaults_are_read_as_python_values():
    text = "float64 w 1\nint32 x 0x1F\nbool b true\nstring s 'it\\'s'\n"
    text += "int8[3] a [1, -2, 3]\nstring[] t [\"a, b\", 'c']"
    assert [default for _, _, default in fields(text)] == [1.0, 31, True, "it's", [1, -2, 3], ["a, b", "c"]]


def test_constants_are_no_fields():
    message = parse("pkg", "msg", "Name", 'uint8 A=1\nstring B = "x y"\nuint8 a')
    assert [(c.name, c.value) for c in message.constants] == [("A", 1), ("B", "x y")]
    assert [f.name for f in message.fields] == ["a"]


def test_comments_are_kept():
    message = parse("pkg", "msg", "Name", "# what it is\n\nfloat64 x  # metres\n")
    assert message.comment == "what it is"
    assert message.fields[0].comment == "metres"


def test_a_service_has_two_parts_and_an_action_three():
    service = parse("pkg", "srv", "Add", "int64 a\n---\nint64 sum\n")
    action = parse("pkg", "action", "Go", "int32 a\n---\nint32 b\n---\nint32 c\n")
    assert isinstance(service, Service) and service.response.name == "Add_Response"
    assert isinstance(action, Action) and action.feedback.fields[0].name == "c"


@pytest.mark.parametrize(
    ("text", "line", "column", "words"),
    [
        ("float64 x\nflot32 y", 2, 1, "did you mean 'float32'?"),
        ("double x", 1, 1, "did you mean 'float64'?"),
        ("int x", 1, 1, "did you mean 'int32'?"),
        ("center geometry_msgs/Point", 1, 1, "the type stands first, then the name: geometry_msgs/Point center"),
        ("radius float64", 1, 1, "the type stands first, then the name: float64 radius"),
        ("float64 x[]", 1, 9, "the brackets stand behind the type: float64[] x"),
        ("float64 x[3]", 1, 9, "the brackets stand behind the type: float64[3] x"),
        ("uint8 battery=100", 1, 7, "a default value stands behind the name without '='"),
        ("float64", 1, 1, "needs a name"),
        ("geometry_msgs/msg/Point center", 1, 1, "'geometry_msgs/msg/Point' is written geometry_msgs/Point"),
        ("geometry_msgs/msg/Point[] centers", 1, 1, "is written geometry_msgs/Point"),
        ("a/b/c/Point center", 1, 1, "unknown type"),
        ("float64 Xy", 1, 9, "no field name"),
        ("float64 x_", 1, 9, "no field name"),
        ("float64 lambda", 1, 9, "Python"),
        ("float64 x\nint8 x", 2, 6, "already defined"),
        ("int8 x 300", 1, 8, "<= 127"),
        ("uint8 lower=1", 1, 7, "no constant name"),
        ("Other X=1", 1, 1, "must be a primitive type"),
        ("int8[0] x", 1, 1, "integer value > 0"),
        ("int8[<=x] x", 1, 1, "integer value > 0"),
        ("int8<=3 x", 1, 1, "only string"),
        ("time t", 1, 1, "builtin_interfaces/Time"),
        ("string<=3 s 'long'", 1, 13, "maximum length of 3"),
        ("int8[2] a [1]", 1, 11, "exactly 2 elements, not 1"),
        ("string s 'a # b'", 1, 10, "has no end"),
        ("  int8 x", 1, 1, "first column"),
    ],
)
def test_an_error_names_line_and_column_and_cure(text, line, column, words):
    with pytest.raises(InterfaceError) as caught:
        parse("pkg", "msg", "Name", text, "Name.msg")
    assert (caught.value.line, caught.value.column) == (line, column)
    assert words in caught.value.message
    assert str(caught.value).startswith(f"Name.msg:{line}:{column}: ")
    assert str(caught.value).splitlines()[-1].index("^") == column + 1


def test_a_missing_separator_is_said():
    with pytest.raises(InterfaceError, match="this one has 0"):
        parse("pkg", "srv", "Add", "int64 a")
    with pytest.raises(InterfaceError, match="this one has 1"):
        parse("pkg", "action", "Go", "int64 a\n---\n")


def test_an_error_in_a_response_counts_lines_of_the_whole_file():
    with pytest.raises(InterfaceError) as caught:
        parse("pkg", "srv", "Add", "int64 a\n---\nint65 b\n")
    assert caught.value.line == 3


def test_bytes_that_are_no_text_are_an_interface_error(tmp_path):
    path = tmp_path / "Bad.msg"
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(InterfaceError, match="not UTF-8"):
        parse_file("pkg", path)


NAMES = st.from_regex(r"[a-z][a-z0-9]{0,8}", fullmatch=True)
TYPES = st.builds(
    FieldType,
    base=st.sampled_from(
        ["bool", "byte", "char", "int8", "uint64", "float32", "float64", "string", "geometry_msgs/msg/Pose"]
    ),
    is_array=st.booleans(),
    size=st.one_of(st.none(), st.integers(1, 9)),
    is_upper_bound=st.booleans(),
).map(lambda t: t if t.is_array and t.size else FieldType(t.base, is_array=t.is_array))


@given(st.lists(st.tuples(TYPES, NAMES), unique_by=lambda pair: pair[1], max_size=6))
def test_what_is_written_is_read_back(pairs):
    import keyword

    pairs = [(kind, name) for kind, name in pairs if not keyword.iskeyword(name)]
    text = "\n".join(f"{kind} {name}" for kind, name in pairs)
    message = parse("pkg", "msg", "Name", text)
    assert [(f.type, f.name) for f in message.fields] == pairs


@given(st.text(alphabet=st.sampled_from("int8 float64[]<=>#='\"\n\t/ABCabc_019.,-\\{}é"), max_size=80))
def test_any_text_is_read_or_refused_with_a_place(text):
    for kind in ("msg", "srv", "action"):
        try:
            assert isinstance(parse("pkg", kind, "Name", text), (Message, Service, Action))
        except InterfaceError as error:
            assert error.line >= 1 and error.column >= 1
