import warnings

import pytest
from rcl_interfaces.msg import SetParametersResult
from rclpy.duration import Duration
from rclpy.impl.implementation_singleton import rclpy_implementation as _rclpy
from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    InvalidQoSProfileException,
    LivelinessPolicy,
    QoSCompatibility,
    QoSDurabilityPolicy,
    QoSHistoryPolicy,
    QoSLivelinessPolicy,
    QoSPolicyKind,
    QoSPresetProfiles,
    QoSProfile,
    QoSReliabilityPolicy,
    ReliabilityPolicy,
    qos_check_compatible,
    qos_policy_name_from_kind,
    qos_profile_action_status_default,
    qos_profile_parameter_events,
    qos_profile_parameters,
    qos_profile_sensor_data,
    qos_profile_services_default,
    qos_profile_system_default,
)
from rclpy.qos_overriding_options import QoSOverridingOptions
from std_msgs.msg import String

BEST_EFFORT, RELIABLE = ReliabilityPolicy.BEST_EFFORT, ReliabilityPolicy.RELIABLE


def profile(**kwargs):
    kwargs.setdefault("depth", 1)
    kwargs.setdefault("liveliness", LivelinessPolicy.AUTOMATIC)
    return QoSProfile(**kwargs)


def test_a_depth_alone_keeps_the_last():
    qos = QoSProfile(depth=5)
    assert (qos.history, qos.depth) == (HistoryPolicy.KEEP_LAST, 5)
    assert (qos.reliability, qos.durability) == (RELIABLE, DurabilityPolicy.VOLATILE)


def test_keep_all_needs_no_depth():
    assert QoSProfile(history=HistoryPolicy.KEEP_ALL).history == HistoryPolicy.KEEP_ALL


@pytest.mark.parametrize("given", [{}, {"reliability": RELIABLE}])
def test_history_or_depth_is_required(given):
    with pytest.raises(InvalidQoSProfileException, match="History and/or depth settings are required"):
        QoSProfile(**given)


def test_keep_last_needs_a_depth():
    with pytest.raises(InvalidQoSProfileException, match="without a depth setting"):
        QoSProfile(history=HistoryPolicy.KEEP_LAST)


def test_a_zero_depth_warns():
    with pytest.warns(UserWarning, match="A zero depth with KEEP_LAST doesn't make sense"):
        QoSProfile(depth=0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        QoSProfile(depth=1)


@pytest.mark.parametrize(
    "given", [{"depth": "a"}, {"depth": 1, "deadline": 1}, {"depth": 1, "reliability": "x"}]
)
def test_values_have_their_types(given):
    with pytest.raises(AssertionError):
        QoSProfile(**given)


def test_an_unknown_argument_is_refused():
    with pytest.raises((AssertionError, TypeError)):
        QoSProfile(depth=1, speed=3)


def test_a_number_becomes_the_policy():
    qos = QoSProfile(depth=1, reliability=2)
    assert qos.reliability is BEST_EFFORT
    with pytest.raises(ValueError):
        QoSProfile(depth=1, reliability=9)


def test_profiles_are_equal_by_value():
    assert QoSProfile(depth=1) == QoSProfile(depth=1)
    assert QoSProfile(depth=1) != QoSProfile(depth=2)
    assert QoSProfile(depth=1) != 1


def test_attributes_can_be_set():
    qos = QoSProfile(depth=1)
    qos.depth = 3
    qos.deadline = Duration(seconds=1)
    assert (qos.depth, qos.deadline) == (3, Duration(seconds=1))
    with pytest.raises(AssertionError):
        qos.depth = "many"


@pytest.mark.parametrize(
    ("enum", "value", "key"),
    [
        (HistoryPolicy, HistoryPolicy.KEEP_ALL, "keep_all"),
        (ReliabilityPolicy, BEST_EFFORT, "best_effort"),
        (DurabilityPolicy, DurabilityPolicy.TRANSIENT_LOCAL, "transient_local"),
        (LivelinessPolicy, LivelinessPolicy.MANUAL_BY_TOPIC, "manual_by_topic"),
    ],
)
def test_policies_have_short_keys(enum, value, key):
    assert value.short_key == key
    assert key in enum.short_keys()
    assert enum.get_from_short_key(key) == value.value
    with pytest.raises(KeyError):
        enum.get_from_short_key("absent")


def test_the_longer_names_are_the_same():
    assert QoSHistoryPolicy is HistoryPolicy
    assert QoSReliabilityPolicy is ReliabilityPolicy
    assert QoSDurabilityPolicy is DurabilityPolicy
    assert QoSLivelinessPolicy is LivelinessPolicy


@pytest.mark.parametrize(
    ("preset", "depth", "reliability", "durability"),
    [
        (qos_profile_sensor_data, 5, BEST_EFFORT, DurabilityPolicy.VOLATILE),
        (qos_profile_services_default, 10, RELIABLE, DurabilityPolicy.VOLATILE),
        (qos_profile_parameters, 1000, RELIABLE, DurabilityPolicy.VOLATILE),
        (qos_profile_parameter_events, 1000, RELIABLE, DurabilityPolicy.VOLATILE),
        (qos_profile_action_status_default, 1, RELIABLE, DurabilityPolicy.TRANSIENT_LOCAL),
        (qos_profile_system_default, 0, ReliabilityPolicy.SYSTEM_DEFAULT, DurabilityPolicy.SYSTEM_DEFAULT),
    ],
)
def test_presets(preset, depth, reliability, durability):
    assert (preset.depth, preset.reliability, preset.durability) == (depth, reliability, durability)


def test_presets_by_key():
    assert QoSPresetProfiles.get_from_short_key("sensor_data") == qos_profile_sensor_data
    assert "services_default" in QoSPresetProfiles.short_keys()
    assert QoSPresetProfiles.SENSOR_DATA.value == qos_profile_sensor_data


@pytest.mark.parametrize(
    "publisher, subscription, verdict, reason",
    [
        ({}, {}, QoSCompatibility.OK, ""),
        (
            {"reliability": BEST_EFFORT},
            {},
            QoSCompatibility.ERROR,
            "ERROR: Best effort publisher and reliable subscription;",
        ),
        (
            {},
            {"durability": DurabilityPolicy.TRANSIENT_LOCAL},
            QoSCompatibility.ERROR,
            "ERROR: Volatile publisher and transient local subscription;",
        ),
        (
            {},
            {"deadline": Duration(seconds=1)},
            QoSCompatibility.ERROR,
            "ERROR: Subscription has a deadline, but publisher does not;",
        ),
        (
            {"deadline": Duration(seconds=2)},
            {"deadline": Duration(seconds=1)},
            QoSCompatibility.ERROR,
            "ERROR: Subscription deadline is less than publisher deadline;",
        ),
        (
            {},
            {"liveliness": LivelinessPolicy.MANUAL_BY_TOPIC},
            QoSCompatibility.ERROR,
            "ERROR: Publisher's liveliness is automatic and subscription's is manual by topic;",
        ),
        (
            {},
            {"liveliness_lease_duration": Duration(seconds=1)},
            QoSCompatibility.ERROR,
            "ERROR: Subscription has a liveliness lease duration, but publisher does not;",
        ),
        (
            {"reliability": ReliabilityPolicy.SYSTEM_DEFAULT},
            {},
            QoSCompatibility.WARNING,
            "WARNING: Reliable subscription, but publisher is system_default;",
        ),
        (
            {"reliability": BEST_EFFORT},
            {"reliability": ReliabilityPolicy.SYSTEM_DEFAULT},
            QoSCompatibility.WARNING,
            "WARNING: Best effort publisher, but subscription is system_default;",
        ),
        (
            {},
            {"durability": DurabilityPolicy.SYSTEM_DEFAULT},
            QoSCompatibility.WARNING,
            "WARNING: Volatile publisher, but subscription is system_default;",
        ),
        (
            {},
            {"liveliness": LivelinessPolicy.SYSTEM_DEFAULT},
            QoSCompatibility.WARNING,
            "WARNING: Publisher's liveliness is automatic, but subscription's is system_default;",
        ),
        (
            {"reliability": BEST_EFFORT, "durability": DurabilityPolicy.TRANSIENT_LOCAL},
            {"reliability": BEST_EFFORT},
            QoSCompatibility.OK,
            "",
        ),
    ],
)
def test_compatibility(publisher, subscription, verdict, reason):
    compatibility, text = qos_check_compatible(profile(**publisher), profile(**subscription))
    assert (compatibility, text) == (verdict, reason)


@pytest.mark.parametrize("kind", list(QoSPolicyKind))
def test_kinds_have_names(kind):
    assert qos_policy_name_from_kind(kind) == kind.name
    assert qos_policy_name_from_kind(int(kind)) == kind.name


def test_what_is_no_kind_is_refused():
    with pytest.raises(ValueError):
        qos_policy_name_from_kind(3)


def test_policies_become_parameters(world):
    node = world.node("n")
    options = QoSOverridingOptions.with_default_policies()
    node.create_publisher(String, "chatter", 10, qos_overriding_options=options)
    prefix = "qos_overrides./chatter.publisher."
    assert node.get_parameter(prefix + "depth").value == 10
    assert node.get_parameter(prefix + "reliability").value == "reliable"
    assert node.get_parameter(prefix + "history").value == "keep_last"


def test_parameters_override_policies(world):
    name = "qos_overrides./chatter.subscription_mine.reliability"
    node = world.node("n", cli_args=["--ros-args", "-p", f"{name}:=best_effort"])
    options = QoSOverridingOptions([QoSPolicyKind.RELIABILITY], entity_id="mine")
    node.create_subscription(String, "chatter", lambda m: None, 10, qos_overriding_options=options)
    world.spin_until(lambda: node.get_subscriptions_info_by_topic("/chatter"))
    (info,) = node.get_subscriptions_info_by_topic("/chatter")
    assert info.qos_profile.reliability == BEST_EFFORT


def test_a_callback_may_refuse_the_overrides(world):
    from rclpy.qos_overriding_options import InvalidQosOverridesError

    options = QoSOverridingOptions.with_default_policies(
        callback=lambda qos: SetParametersResult(successful=False, reason="not like that")
    )
    with pytest.raises(InvalidQosOverridesError, match="not like that"):
        world.node().create_publisher(String, "chatter", 10, qos_overriding_options=options)


def test_profiles_of_the_c_module():
    profile = _rclpy.rmw_qos_profile_t.predefined("qos_profile_sensor_data")
    assert QoSProfile(**profile.to_dict()) == qos_profile_sensor_data
    with pytest.raises(ValueError, match="unknown rmw_qos_profile"):
        _rclpy.rmw_qos_profile_t.predefined("qos_profile_mine")
