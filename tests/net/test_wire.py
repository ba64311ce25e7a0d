"""The format, letter by letter as rmw_zenoh's design document shows it, and what strangers may send in its place."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from coursekit.net.wire.attachment import Attachment, read_attachment
from coursekit.net.wire.names import data_key
from coursekit.net.wire.quality import FOREVER, Quality, read_quality
from coursekit.net.wire.token import CLIENT, KINDS, NODE, PUBLISHER, SERVER, SUBSCRIPTION, Token, gid_of, read_token

STRING_HASH = "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"
ADD_HASH = "RIHS01_e118de6bf5eeb66a2491b5bda11202e7b68f198d6f67922cf30364858239c81a"
LISTENER = "@ros2_lv/2/aac3178e146ba6f1fc6e6a4085e77f21/0/0/NN/%/%/listener"
GOLDEN = {
    LISTENER: Token(2, "aac3178e146ba6f1fc6e6a4085e77f21", "0", "0", NODE, "/", "listener"),
    "@ros2_lv/2/aac3178e146ba6f1fc6e6a4085e77f21/0/10/MS/%/%/listener/%chatter/std_msgs::msg::dds_::String_/"
    f"{STRING_HASH}/::,10:,:,:,,": Token(
        2, "aac3178e146ba6f1fc6e6a4085e77f21", "0", "10", SUBSCRIPTION, "/", "listener",
        "/chatter", "std_msgs/msg/String", STRING_HASH, Quality(depth=10)),
    "@ros2_lv/2/8b20917502ee955ac4476e0266340d5c/0/10/MP/%/%/talker/%chatter/std_msgs::msg::dds_::String_/"
    f"{STRING_HASH}/::,7:,:,:,,": Token(
        2, "8b20917502ee955ac4476e0266340d5c", "0", "10", PUBLISHER, "/", "talker",
        "/chatter", "std_msgs/msg/String", STRING_HASH, Quality(depth=7)),
    "@ros2_lv/2/f9980ee0495eaafb3e38f0d19e2eae12/0/10/SS/%/%/add_two_ints_server/%add_two_ints/"
    f"example_interfaces::srv::dds_::AddTwoInts_/{ADD_HASH}/::,10:,:,:,,": Token(
        2, "f9980ee0495eaafb3e38f0d19e2eae12", "0", "10", SERVER, "/", "add_two_ints_server",
        "/add_two_ints", "example_interfaces/srv/AddTwoInts", ADD_HASH, Quality(depth=10)),
    "@ros2_lv/0/1f/1/5/SC/%/%robot1%arm/caller/%robot1%add/example_interfaces::srv::dds_::AddTwoInts_/"
    "TypeHashNotSupported/2:1:2,:1,500000000:,:3,2,0": Token(
        0, "1f", "1", "5", CLIENT, "/robot1/arm", "caller", "/robot1/add", "example_interfaces/srv/AddTwoInts",
        "TypeHashNotSupported",
        Quality(reliability=2, durability=1, history=2, deadline=1_500_000_000, liveliness=3, lease=2_000_000_000)),
}  # fmt: skip


@pytest.mark.parametrize("text", GOLDEN, ids=lambda text: text.split("/")[5])
def test_a_token_is_written_and_read_as_rmw_zenoh_does(text):
    assert read_token(text) == GOLDEN[text]
    assert GOLDEN[text].text() == text


@pytest.mark.parametrize(("quality", "text"), [
    (Quality(), "::,:,:,:,,"),
    (Quality(depth=5, reliability=2), "2::,5:,:,:,,"),
    (Quality(depth=1, durability=1), ":1:,1:,:,:,,"),
    (Quality(history=2, lifespan=1), "::2,:,:0,1:,,"),
])  # fmt: skip
def test_what_is_rmw_zenohs_default_is_left_out_of_a_quality(quality, text):
    assert quality.text() == text and read_quality(text) == quality


def test_a_duration_that_is_written_out_though_it_has_no_end_is_read_as_such():
    assert read_quality("::,10:9223372036,854775807:9223372036,:,,").deadline == FOREVER


def test_keys_of_messages_are_those_of_the_design_document():
    key = data_key(2, "/chatter", "std_msgs/msg/String", STRING_HASH)
    assert key == f"2/chatter/std_msgs::msg::dds_::String_/{STRING_HASH}"
    key = data_key(0, "/r1/a/_action/feedback", "p/action/A_FeedbackMessage")
    assert key == "0/r1/a/_action/feedback/p::action::dds_::A_FeedbackMessage_/*"


def test_a_gid_is_the_xxh3_of_the_token_low_half_first():
    # The reference values of XXH3's 128 bits for no input: low 6001c324468d497f, high 99aa06d3014798d8.
    assert gid_of("") == bytes.fromhex("7f498d4624c30160d8984701d306aa99")


def test_an_attachment_is_two_numbers_and_a_gid_with_its_length():
    data = Attachment(7, 0x0102030405060708, bytes(range(16))).data()
    assert data.hex() == "0700000000000000" "0807060504030201" "10" "000102030405060708090a0b0c0d0e0f"
    assert read_attachment(data) == Attachment(7, 0x0102030405060708, bytes(range(16)))


NAMES = st.from_regex(r"(/[a-z_][a-z0-9_]{0,8}){1,3}", fullmatch=True)
QUALITIES = st.builds(
    Quality, st.integers(0, 5), st.integers(0, 5), st.integers(0, 5), st.integers(0, 10**6),
    st.integers(0, FOREVER), st.integers(0, FOREVER), st.integers(0, 5), st.integers(0, FOREVER),
)  # fmt: skip
TOKENS = st.builds(
    Token, st.integers(0, 232), st.from_regex("[0-9a-f]{1,32}", fullmatch=True), st.just("1"), st.just("2"),
    st.sampled_from(KINDS[1:]), NAMES, st.from_regex("[a-z]{1,9}", fullmatch=True), NAMES, st.just("a_msgs/msg/B2"),
    st.just(STRING_HASH), QUALITIES,
)  # fmt: skip


@given(TOKENS)
def test_what_is_written_is_read_again(token):
    assert read_token(token.text()) == token


@given(st.one_of(
    st.text(max_size=300),
    st.builds("/".join, st.lists(st.sampled_from(
        ["@ros2_lv", "0", "1", "NN", "MP", "%", "%a", "a", "", "..", "-1", "9" * 30, "²", "std_msgs::msg::dds_::String_",
         "::,:,:,:,,", ":::::", "%%", "*", "é", "a b", "1e9"]), min_size=7, max_size=15)),
    st.builds(lambda text, at, new: text[:at] + new + text[at + 1 :], st.sampled_from(list(GOLDEN)), st.integers(0, 200),
              st.text(max_size=3)),
))  # fmt: skip
def test_what_a_stranger_announces_is_a_token_or_refused(text):
    try:
        token = read_token(text)
    except ValueError as error:
        assert str(error)
    else:
        assert token.text().isascii() and read_token(token.text()) == token


@given(st.binary(max_size=80))
def test_what_a_stranger_attaches_is_an_attachment_or_refused(data):
    try:
        assert read_attachment(data).data() == data
    except ValueError as error:
        assert str(error)
