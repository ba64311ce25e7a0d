"""The executables of the underlay, for `ros2 run PACKAGE EXECUTABLE`.

Each becomes a program in `coursekit/lib/PACKAGE` when coursekit is built or installed. To add one, add a line here and run
`python3 start.py setup`. A new package also needs an entry in `share/ament_index` (tests/building/test_index.py).
"""

EXECUTABLES: dict[str, dict[str, str]] = {
    "action_tutorials_cpp": {
        "fibonacci_action_client": "coursekit.nodes.demo_nodes.fibonacci_cpp:client",
        "fibonacci_action_server": "coursekit.nodes.demo_nodes.fibonacci_cpp:server",
    },
    "action_tutorials_py": {
        "fibonacci_action_client": "coursekit.nodes.demo_nodes.fibonacci_action_client:main",
        "fibonacci_action_server": "coursekit.nodes.demo_nodes.fibonacci_action_server:main",
    },
    "apriltag_ros": {
        "apriltag_node": "coursekit.nodes.apriltag.node:main",
    },
    "composition": {
        "client_component": "coursekit.nodes.composition.nodes:client",
        "dlopen_composition": "coursekit.nodes.composition.dlopen:main",
        "linktime_composition": "coursekit.nodes.composition.dlopen:linked",
        "listener_component": "coursekit.nodes.composition.nodes:listener",
        "manual_composition": "coursekit.nodes.composition.nodes:all_in_one",
        "server_component": "coursekit.nodes.composition.nodes:server",
        "talker_component": "coursekit.nodes.composition.nodes:talker",
    },
    "controller_manager": {
        "ros2_control_node": "coursekit.nodes.control.ros2_control_node:main",
        "spawner": "coursekit.nodes.control.spawner:main",
        "spawner.py": "coursekit.nodes.control.spawner:main",
        "unspawner": "coursekit.nodes.control.unspawner:main",
        "unspawner.py": "coursekit.nodes.control.unspawner:main",
    },
    "coursekit_robots": {
        "odd_adder": "coursekit.nodes.examples.odd_adder:main",
        "practice_base": "coursekit.nodes.practice_robot.base:main",
        "practice_meter": "coursekit.nodes.practice_robot.meter:main",
    },
    "demo_nodes_cpp": {
        "add_two_ints_client": "coursekit.nodes.demo_nodes.services:client_cpp",
        "add_two_ints_client_async": "coursekit.nodes.demo_nodes.services:client_cpp",
        "add_two_ints_server": "coursekit.nodes.demo_nodes.services:server_cpp",
        "content_filtering_publisher": "coursekit.nodes.demo_nodes.temperature:publisher",
        "content_filtering_subscriber": "coursekit.nodes.demo_nodes.temperature:subscriber",
        "even_parameters_node": "coursekit.nodes.demo_nodes.even_parameters:main",
        "list_parameters": "coursekit.nodes.demo_nodes.own_parameters:list_parameters",
        "list_parameters_async": "coursekit.nodes.demo_nodes.own_parameters:list_parameters_async",
        "listener": "coursekit.nodes.demo_nodes.listener:main_cpp",
        "listener_best_effort": "coursekit.nodes.demo_nodes.listener:best_effort",
        "listener_serialized_message": "coursekit.nodes.demo_nodes.serialized_cpp:listener",
        "one_off_timer": "coursekit.nodes.demo_nodes.timers:one_off",
        "parameter_blackboard": "coursekit.nodes.demo_nodes.parameter_blackboard:main",
        "parameter_event_handler": "coursekit.nodes.demo_nodes.parameter_watcher:main",
        "parameter_events": "coursekit.nodes.demo_nodes.parameter_events:events",
        "parameter_events_async": "coursekit.nodes.demo_nodes.parameter_events:events_async",
        "reuse_timer": "coursekit.nodes.demo_nodes.timers:reuse",
        "set_and_get_parameters": "coursekit.nodes.demo_nodes.own_parameters:set_and_get",
        "set_and_get_parameters_async": "coursekit.nodes.demo_nodes.own_parameters:set_and_get_async",
        "talker": "coursekit.nodes.demo_nodes.talker:main_cpp",
        "talker_loaned_message": "coursekit.nodes.demo_nodes.talker_loaned:main",
        "talker_serialized_message": "coursekit.nodes.demo_nodes.serialized_cpp:talker",
    },
    "demo_nodes_py": {
        "add_two_ints_client": "coursekit.nodes.demo_nodes.services:client",
        "add_two_ints_client_async": "coursekit.nodes.demo_nodes.services:client_async",
        "add_two_ints_server": "coursekit.nodes.demo_nodes.services:server",
        "async_param_client": "coursekit.nodes.demo_nodes.async_param_client:main",
        "listener": "coursekit.nodes.demo_nodes.listener:main",
        "listener_qos": "coursekit.nodes.demo_nodes.qos:listener",
        "listener_serialized": "coursekit.nodes.demo_nodes.listener_serialized:main",
        "talker": "coursekit.nodes.demo_nodes.talker:main",
        "talker_qos": "coursekit.nodes.demo_nodes.qos:talker",
    },
    "depth_image_proc": {
        "point_cloud_xyz_node": "coursekit.nodes.image_pipeline.depth_nodes:xyz",
        "point_cloud_xyzrgb_node": "coursekit.nodes.image_pipeline.depth_nodes:xyzrgb",
    },
    "depthimage_to_laserscan": {
        "depthimage_to_laserscan_node": "coursekit.nodes.pointcloud_to_laserscan.depth:main",
    },
    "diagnostic_aggregator": {
        "aggregator_node": "coursekit.nodes.diagnostic_aggregator.aggregator:main",
    },
    "dummy_map_server": {
        "dummy_map_server": "coursekit.nodes.dummy_robot.map_server:main",
    },
    "dummy_sensors": {
        "dummy_joint_states": "coursekit.nodes.dummy_robot.sensors:joint_states",
        "dummy_laser": "coursekit.nodes.dummy_robot.sensors:laser",
    },
    "examples_rclcpp_minimal_client": {
        "client_main": "coursekit.nodes.examples.services:client_cpp",
    },
    "examples_rclcpp_minimal_publisher": {
        "publisher_lambda": "coursekit.nodes.examples.topics:publisher_cpp",
        "publisher_member_function": "coursekit.nodes.examples.topics:publisher_cpp",
        "publisher_not_composable": "coursekit.nodes.examples.topics:publisher_cpp",
        "publisher_wait_for_all_acked": "coursekit.nodes.examples.topics:publisher_acknowledged_cpp",
    },
    "examples_rclcpp_minimal_service": {
        "service_main": "coursekit.nodes.examples.services:service_cpp",
    },
    "examples_rclcpp_minimal_subscriber": {
        "subscriber_lambda": "coursekit.nodes.examples.topics:subscriber_cpp",
        "subscriber_member_function": "coursekit.nodes.examples.topics:subscriber_cpp",
        "subscriber_not_composable": "coursekit.nodes.examples.topics:subscriber_cpp",
    },
    "examples_rclcpp_minimal_timer": {
        "timer_lambda": "coursekit.nodes.examples.topics:timer_cpp",
        "timer_member_function": "coursekit.nodes.examples.topics:timer_cpp",
    },
    "examples_rclpy_executors": {
        "callback_group": "coursekit.nodes.examples.executors:callback_group",
        "composed": "coursekit.nodes.examples.executors:composed",
        "custom_callback_group": "coursekit.nodes.examples.executors:custom_callback_group",
        "custom_executor": "coursekit.nodes.examples.executors:custom_executor",
        "listener": "coursekit.nodes.examples.executors:listener",
        "talker": "coursekit.nodes.examples.executors:talker",
    },
    "examples_rclpy_guard_conditions": {
        "trigger_guard_condition": "coursekit.nodes.examples.guard_condition:main",
    },
    "examples_rclpy_minimal_action_client": {
        "client": "coursekit.nodes.examples.action_client:client",
        "client_asyncio": "coursekit.nodes.examples.action_client:client",
        "client_cancel": "coursekit.nodes.examples.action_client:client_cancel",
        "client_not_composable": "coursekit.nodes.examples.action_client:client",
    },
    "examples_rclpy_minimal_action_server": {
        "server": "coursekit.nodes.examples.action_server:server",
        "server_defer": "coursekit.nodes.examples.action_server:server_defer",
        "server_not_composable": "coursekit.nodes.examples.action_server:server",
        "server_queue_goals": "coursekit.nodes.examples.action_server:server_queue_goals",
        "server_single_goal": "coursekit.nodes.examples.action_server:server_single_goal",
    },
    "examples_rclpy_minimal_client": {
        "client": "coursekit.nodes.examples.services:client",
        "client_async": "coursekit.nodes.examples.services:client_async",
        "client_async_callback": "coursekit.nodes.examples.services:client_async_callback",
        "client_async_member_function": "coursekit.nodes.examples.services:client_async_member_function",
    },
    "examples_rclpy_minimal_publisher": {
        "publisher_local_function": "coursekit.nodes.examples.topics:publisher",
        "publisher_member_function": "coursekit.nodes.examples.topics:publisher",
        "publisher_old_school": "coursekit.nodes.examples.topics:publisher",
    },
    "examples_rclpy_minimal_service": {
        "service": "coursekit.nodes.examples.services:service",
        "service_member_function": "coursekit.nodes.examples.services:service",
    },
    "examples_rclpy_minimal_subscriber": {
        "subscriber_lambda": "coursekit.nodes.examples.topics:subscriber",
        "subscriber_member_function": "coursekit.nodes.examples.topics:subscriber",
        "subscriber_old_school": "coursekit.nodes.examples.topics:subscriber",
    },
    "examples_rclpy_pointcloud_publisher": {
        "pointcloud_publisher": "coursekit.nodes.examples.pointcloud:main",
    },
    "explore_lite": {
        "explore": "coursekit.nodes.explore_lite.explore:main",
    },
    "gazebo_ros": {
        "gzclient": "coursekit.nodes.gazebo.gzclient:main",
        "gzserver": "coursekit.nodes.gazebo.gzserver:main",
        "spawn_entity.py": "coursekit.nodes.gazebo.spawn_entity:main",
    },
    "image_proc": {
        "crop_decimate_node": "coursekit.nodes.image_pipeline.crop:main",
        "debayer_node": "coursekit.nodes.image_pipeline.debayer:main",
        "rectify_node": "coursekit.nodes.image_pipeline.rectify:main",
        "resize_node": "coursekit.nodes.image_pipeline.resize:main",
    },
    "image_publisher": {
        "components/image_publisher": "coursekit.nodes.cameras.image_publisher:component",
        "image_publisher_node": "coursekit.nodes.cameras.image_publisher:main",
    },
    "image_tools": {
        "cam2image": "coursekit.nodes.image_tools.cam2image:main",
        "showimage": "coursekit.nodes.image_tools.showimage:main",
    },
    "image_transport": {
        "list_transports": "coursekit.nodes.images.republish:list_transports",
        "republish": "coursekit.nodes.images.republish:main",
    },
    "image_view": {
        "image_saver": "coursekit.nodes.image_view.saver:main",
        "image_view": "coursekit.nodes.image_view.view:main",
    },
    "imu_complementary_filter": {
        "complementary_filter_node": "coursekit.nodes.imu_tools.filters:complementary",
    },
    "imu_filter_madgwick": {
        "imu_filter_madgwick_node": "coursekit.nodes.imu_tools.filters:madgwick",
    },
    "intra_process_demo": {
        "camera_node": "coursekit.nodes.intra_process.images:camera",
        "cyclic_pipeline": "coursekit.nodes.intra_process.pipelines:cyclic",
        "image_pipeline_all_in_one": "coursekit.nodes.intra_process.images:all_in_one",
        "image_pipeline_with_two_image_view": "coursekit.nodes.intra_process.images:two_views",
        "image_view_node": "coursekit.nodes.intra_process.images:view",
        "two_node_pipeline": "coursekit.nodes.intra_process.pipelines:two_nodes",
        "watermark_node": "coursekit.nodes.intra_process.images:watermark",
    },
    "joint_state_publisher": {
        "joint_state_publisher": "coursekit.nodes.robots.joint_state_publisher:main",
    },
    "joint_state_publisher_gui": {
        "joint_state_publisher_gui": "coursekit.nodes.robots.joint_state_publisher_gui:main",
    },
    "joy": {
        "joy_enumerate_devices": "coursekit.nodes.joy.joy_node:enumerate_devices",
        "joy_node": "coursekit.nodes.joy.joy_node:main",
    },
    "joy_linux": {
        "joy_linux_node": "coursekit.nodes.joy.joy_linux_node:main",
    },
    "laser_filters": {
        "scan_to_scan_filter_chain": "coursekit.nodes.laser_filters.chain:main",
    },
    "lifecycle": {
        "lifecycle_listener": "coursekit.nodes.lifecycle_demo.listener:main",
        "lifecycle_service_client": "coursekit.nodes.lifecycle_demo.service_client:main",
        "lifecycle_talker": "coursekit.nodes.lifecycle_demo.talker:main",
    },
    "lifecycle_py": {
        "lifecycle_talker": "coursekit.nodes.lifecycle_demo.talker:main",
    },
    "logging_demo": {
        "components/logger_config": "coursekit.nodes.logging_demo.nodes:config",
        "components/logger_usage": "coursekit.nodes.logging_demo.nodes:usage",
        "logging_demo_main": "coursekit.nodes.logging_demo.nodes:main",
    },
    "nav2_amcl": {
        "amcl": "coursekit.nodes.nav2.amcl:main",
    },
    "nav2_behaviors": {
        "behavior_server": "coursekit.nodes.nav2.behavior_server:main",
    },
    "nav2_bt_navigator": {
        "bt_navigator": "coursekit.nodes.nav2.bt_navigator:main",
    },
    "nav2_collision_monitor": {
        "collision_monitor": "coursekit.nodes.nav2.collision_monitor:main",
    },
    "nav2_controller": {
        "controller_server": "coursekit.nodes.nav2.controller_server:main",
    },
    "nav2_lifecycle_manager": {
        "lifecycle_manager": "coursekit.nodes.nav2.lifecycle_manager:main",
    },
    "nav2_map_server": {
        "costmap_filter_info_server": "coursekit.nodes.nav2.filter_info_server:main",
        "map_saver_cli": "coursekit.nodes.nav2.map_saver:main_cli",
        "map_saver_server": "coursekit.nodes.nav2.map_saver:main_server",
        "map_server": "coursekit.nodes.nav2.map_server:main",
    },
    "nav2_planner": {
        "planner_server": "coursekit.nodes.nav2.planner_server:main",
    },
    "nav2_smoother": {
        "smoother_server": "coursekit.nodes.nav2.smoother_server:main",
    },
    "nav2_util": {
        "lifecycle_bringup": "coursekit.nodes.nav2.lifecycle_bringup:main",
    },
    "nav2_velocity_smoother": {
        "velocity_smoother": "coursekit.nodes.nav2.velocity_smoother:main",
    },
    "nav2_waypoint_follower": {
        "waypoint_follower": "coursekit.nodes.nav2.waypoint_follower:main",
    },
    "pointcloud_to_laserscan": {
        "laserscan_to_pointcloud_node": "coursekit.nodes.pointcloud_to_laserscan.nodes:to_cloud",
        "pointcloud_to_laserscan_node": "coursekit.nodes.pointcloud_to_laserscan.nodes:to_scan",
    },
    "quality_of_service_demo_cpp": {
        "deadline": "coursekit.nodes.qos_demo.cpp:deadline",
        "incompatible_qos": "coursekit.nodes.qos_demo.cpp:incompatible",
        "interactive_publisher": "coursekit.nodes.qos_demo.interactive:publisher",
        "interactive_subscriber": "coursekit.nodes.qos_demo.interactive:subscriber",
        "lifespan": "coursekit.nodes.qos_demo.cpp:lifespan",
        "liveliness": "coursekit.nodes.qos_demo.cpp:liveliness",
        "message_lost_listener": "coursekit.nodes.qos_demo.lost:listener_cpp",
        "message_lost_talker": "coursekit.nodes.qos_demo.lost:talker",
        "qos_overrides_listener": "coursekit.nodes.qos_demo.overrides:listener_cpp",
        "qos_overrides_talker": "coursekit.nodes.qos_demo.overrides:talker_cpp",
    },
    "quality_of_service_demo_py": {
        "deadline": "coursekit.nodes.qos_demo.timed:deadline",
        "incompatible_qos": "coursekit.nodes.qos_demo.incompatible:main",
        "lifespan": "coursekit.nodes.qos_demo.timed:lifespan",
        "liveliness": "coursekit.nodes.qos_demo.timed:liveliness",
        "message_lost_listener": "coursekit.nodes.qos_demo.lost:listener",
        "qos_overrides_listener": "coursekit.nodes.qos_demo.overrides:listener",
        "qos_overrides_talker": "coursekit.nodes.qos_demo.overrides:talker",
    },
    "rclcpp_components": {
        "component_container": "coursekit.nodes.components.container:main",
        "component_container_isolated": "coursekit.nodes.components.container:main",
        "component_container_mt": "coursekit.nodes.components.container:main",
    },
    "rf2o_laser_odometry": {
        "rf2o_laser_odometry_node": "coursekit.nodes.laser_odometry.rf2o:main",
    },
    "robot_localization": {
        "ekf_node": "coursekit.nodes.robot_localization.filter_node:ekf",
        "navsat_transform_node": "coursekit.nodes.robot_localization.navsat_node:main",
        "ukf_node": "coursekit.nodes.robot_localization.filter_node:ukf",
    },
    "robot_state_publisher": {
        "robot_state_publisher": "coursekit.nodes.robots.robot_state_publisher:main",
    },
    "ros2_controllers_test_nodes": {
        "publisher_forward_position_controller": "coursekit.nodes.ros2_controllers_test_nodes.forward_position:main",
        "publisher_joint_trajectory_controller": "coursekit.nodes.ros2_controllers_test_nodes.joint_trajectory:main",
    },
    "ros_gz_bridge": {
        "bridge_node": "coursekit.nodes.gz.bridge:main",
        "parameter_bridge": "coursekit.nodes.gz.bridge:main",
    },
    "ros_gz_image": {
        "image_bridge": "coursekit.nodes.gz.image_bridge:main",
    },
    "ros_gz_sim": {
        "create": "coursekit.nodes.gz.create:main",
    },
    "ros_ign_bridge": {
        "parameter_bridge": "coursekit.nodes.gz.bridge:main",
    },
    "ros_ign_gazebo": {
        "create": "coursekit.nodes.gz.create:main",
    },
    "ros_ign_image": {
        "image_bridge": "coursekit.nodes.gz.image_bridge:main",
    },
    "rqt_console": {
        "rqt_console": "coursekit.nodes.rqt.rqt:console",
    },
    "rqt_graph": {
        "rqt_graph": "coursekit.nodes.rqt.rqt:graph",
    },
    "rqt_gui": {
        "rqt_gui": "coursekit.nodes.rqt.rqt:gui",
    },
    "rqt_image_view": {
        "rqt_image_view": "coursekit.nodes.images.viewer:main",
    },
    "rqt_plot": {
        "rqt_plot": "coursekit.nodes.rqt.plot:main",
    },
    "rqt_publisher": {
        "rqt_publisher": "coursekit.nodes.rqt.rqt:publisher",
    },
    "rqt_reconfigure": {
        "rqt_reconfigure": "coursekit.nodes.rqt.rqt:reconfigure",
    },
    "rqt_robot_steering": {
        "rqt_robot_steering": "coursekit.nodes.rqt.rqt:robot_steering",
    },
    "rqt_service_caller": {
        "rqt_service_caller": "coursekit.nodes.rqt.rqt:service_caller",
    },
    "rqt_tf_tree": {
        "rqt_tf_tree": "coursekit.nodes.rqt.rqt:tf_tree",
    },
    "rqt_topic": {
        "rqt_topic": "coursekit.nodes.rqt.rqt:topic",
    },
    "rviz2": {
        "rviz2": "coursekit.nodes.rviz.rviz2:main",
    },
    "slam_toolbox": {
        "async_slam_toolbox_node": "coursekit.nodes.slam_toolbox.nodes:main_async",
        "lifelong_slam_toolbox_node": "coursekit.nodes.slam_toolbox.nodes:main_lifelong",
        "localization_slam_toolbox_node": "coursekit.nodes.slam_toolbox.nodes:main_localization",
        "map_and_localization_slam_toolbox_node": "coursekit.nodes.slam_toolbox.nodes:main_map_and_localization",
        "sync_slam_toolbox_node": "coursekit.nodes.slam_toolbox.nodes:main_sync",
    },
    "teleop_twist_joy": {
        "teleop_node": "coursekit.nodes.teleop_twist_joy.teleop:main",
    },
    "teleop_twist_keyboard": {
        "teleop_twist_keyboard": "coursekit.nodes.teleop.keyboard:main",
    },
    "tf2_ros": {
        "buffer_server": "coursekit.nodes.tf2.buffer_server:main",
        "components/static_transform_broadcaster_node": "coursekit.nodes.tf2.static_publisher:component",
        "static_transform_publisher": "coursekit.nodes.tf2.static_publisher:main",
        "tf2_echo": "coursekit.nodes.tf2.echo:main",
        "tf2_monitor": "coursekit.nodes.tf2.monitor:main",
    },
    "tf2_tools": {
        "view_frames": "coursekit.view.view_frames:main",
    },
    "topic_monitor": {
        "data_publisher": "coursekit.nodes.topic_monitor.data_publisher:main",
        "topic_monitor": "coursekit.nodes.topic_monitor.monitor:main",
    },
    "topic_tools": {
        "delay": "coursekit.nodes.topic_tools.tools:delay",
        "drop": "coursekit.nodes.topic_tools.tools:drop",
        "mux": "coursekit.nodes.topic_tools.mux:main",
        "relay": "coursekit.nodes.topic_tools.tools:relay",
        "relay_field": "coursekit.nodes.topic_tools.computed:relay_field",
        "throttle": "coursekit.nodes.topic_tools.tools:throttle",
        "transform": "coursekit.nodes.topic_tools.computed:transform",
    },
    "turtle_tf2_cpp": {
        "dynamic_frame_tf2_broadcaster": "coursekit.nodes.turtle_tf2.cpp:dynamic",
        "fixed_frame_tf2_broadcaster": "coursekit.nodes.turtle_tf2.cpp:fixed",
        "static_turtle_tf2_broadcaster": "coursekit.nodes.turtle_tf2.cpp:static",
        "turtle_tf2_broadcaster": "coursekit.nodes.turtle_tf2.cpp:turtle",
        "turtle_tf2_listener": "coursekit.nodes.turtle_tf2.cpp:listener",
        "turtle_tf2_message_filter": "coursekit.nodes.turtle_tf2.cpp:drawer",
    },
    "turtle_tf2_py": {
        "dynamic_frame_tf2_broadcaster": "coursekit.nodes.turtle_tf2.broadcasters:dynamic",
        "fixed_frame_tf2_broadcaster": "coursekit.nodes.turtle_tf2.broadcasters:fixed",
        "static_turtle_tf2_broadcaster": "coursekit.nodes.turtle_tf2.broadcasters:static",
        "turtle_tf2_broadcaster": "coursekit.nodes.turtle_tf2.broadcasters:turtle",
        "turtle_tf2_listener": "coursekit.nodes.turtle_tf2.listener:main",
        "turtle_tf2_message_broadcaster": "coursekit.nodes.turtle_tf2.messages:main",
    },
    "turtlesim": {
        "draw_square": "coursekit.nodes.turtlesim.draw_square:main",
        "mimic": "coursekit.nodes.turtlesim.mimic:main",
        "turtle_teleop_key": "coursekit.nodes.turtlesim.teleop:main",
        "turtlesim_node": "coursekit.nodes.turtlesim.turtlesim_node:main",
    },
    "twist_mux": {
        "joystick_relay.py": "coursekit.nodes.twist_mux.joystick:main",
        "twist_marker": "coursekit.nodes.twist_mux.marker:main",
        "twist_mux": "coursekit.nodes.twist_mux.mux:main",
    },
    "twist_stamper": {
        "twist_stamper": "coursekit.nodes.twist_stamper.nodes:stamper",
        "twist_unstamper": "coursekit.nodes.twist_stamper.nodes:unstamper",
    },
    "urdfdom": {
        "check_urdf": "coursekit.cli.robot_commands:check_urdf",
        "urdf_to_graphviz": "coursekit.cli.robot_commands:urdf_to_graphviz",
    },
    "usb_cam": {
        "usb_cam_node_exe": "coursekit.nodes.cameras.usb_cam:main",
    },
    "v4l2_camera": {
        "v4l2_camera_node": "coursekit.nodes.cameras.v4l2_camera:main",
    },
    "xacro": {
        "xacro": "coursekit.cli.robot_commands:xacro",
    },
}
"""Module and function by package and executable."""
