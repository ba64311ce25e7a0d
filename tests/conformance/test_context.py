import pytest
import rclpy
from rclpy.context import Context
from rclpy.exceptions import NotInitializedException


def test_a_new_context_is_not_ok():
    assert not Context().ok()


def test_init_makes_it_ok_and_shutdown_ends_that():
    context = Context()
    rclpy.init(context=context)
    assert context.ok()
    assert rclpy.ok(context=context)
    rclpy.shutdown(context=context)
    assert not context.ok()


def test_a_second_init_is_refused():
    context = Context()
    rclpy.init(context=context)
    with pytest.raises(RuntimeError, match=r"Context\.init\(\) must only be called once"):
        rclpy.init(context=context)
    rclpy.shutdown(context=context)


def test_a_second_shutdown_is_refused():
    context = Context()
    rclpy.init(context=context)
    rclpy.shutdown(context=context)
    with pytest.raises(RuntimeError):
        rclpy.shutdown(context=context)


def test_try_shutdown_may_come_twice():
    context = Context()
    rclpy.init(context=context)
    context.try_shutdown()
    context.try_shutdown()
    assert not context.ok()


def test_module_level_try_shutdown_may_come_twice():
    rclpy.init()
    rclpy.try_shutdown()
    rclpy.try_shutdown()
    assert not rclpy.ok()


def test_shutdown_without_init_is_refused():
    with pytest.raises(RuntimeError):
        rclpy.shutdown(context=Context())


def test_the_default_context_can_be_used_again_and_again():
    for _ in range(3):
        rclpy.init()
        assert rclpy.ok()
        rclpy.shutdown()
        assert not rclpy.ok()


def test_a_negative_domain_is_refused():
    with pytest.raises(RuntimeError):
        rclpy.init(context=Context(), domain_id=-1)


def test_the_domain_is_kept():
    context = Context()
    rclpy.init(context=context, domain_id=7)
    assert context.get_domain_id() == 7
    rclpy.shutdown(context=context)


def test_a_node_needs_an_initialised_context():
    with pytest.raises(NotInitializedException, match=r"rclpy\.init\(\) has not been called"):
        rclpy.create_node("node", context=Context())


def test_shutdown_calls_back():
    context = Context()
    rclpy.init(context=context)
    called = []
    context.on_shutdown(lambda: called.append(True))
    rclpy.shutdown(context=context)
    assert called == [True]


def test_contexts_do_not_disturb_each_other():
    first, second = Context(), Context()
    rclpy.init(context=first)
    rclpy.init(context=second)
    rclpy.shutdown(context=first)
    assert second.ok()
    rclpy.shutdown(context=second)


@pytest.mark.parametrize("args", [["--ros-args", "--unknown"], ["--ros-args", "word"]])
def test_unknown_ros_arguments_are_refused(args):
    from rclpy._rclpy_pybind11 import UnknownROSArgsError

    with pytest.raises(UnknownROSArgsError, match=args[1]):
        rclpy.init(context=Context(), args=args)


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["-r"], "Couldn't parse trailing -r flag"),
        (["-r", "a"], "Couldn't parse remap rule: '-r a'"),
        (["-p", "a:=[1,x]"], "Couldn't parse parameter override rule"),
        (["--params-file", "/nope.yaml"], "Couldn't parse params file"),
        (["--log-level", "loud"], "Couldn't parse log level"),
    ],
)
def test_a_bad_rule_is_refused_with_its_text(words, reason):
    with pytest.raises(RuntimeError, match=reason):
        rclpy.init(context=Context(), args=["--ros-args", *words])


def test_arguments_that_are_no_text_are_refused():
    with pytest.raises(UnicodeEncodeError):
        rclpy.init(context=Context(), args=["robot", "Ragnar\udcc3\udcb6k"])
