"""The libraries of nav2's own tree nodes: the default of bt_navigator's parameter `plugin_lib_names`, without "nav2_"."""

LIBRARIES = (
    "compute_path_to_pose_action_bt_node", "compute_path_through_poses_action_bt_node", "smooth_path_action_bt_node",
    "follow_path_action_bt_node", "spin_action_bt_node", "wait_action_bt_node", "assisted_teleop_action_bt_node",
    "back_up_action_bt_node", "drive_on_heading_bt_node", "clear_costmap_service_bt_node", "is_stuck_condition_bt_node",
    "goal_reached_condition_bt_node", "initial_pose_received_condition_bt_node", "goal_updated_condition_bt_node",
    "globally_updated_goal_condition_bt_node", "is_path_valid_condition_bt_node",
    "reinitialize_global_localization_service_bt_node", "rate_controller_bt_node", "distance_controller_bt_node",
    "speed_controller_bt_node", "truncate_path_action_bt_node", "truncate_path_local_action_bt_node",
    "goal_updater_node_bt_node", "recovery_node_bt_node", "pipeline_sequence_bt_node", "round_robin_node_bt_node",
    "transform_available_condition_bt_node", "time_expired_condition_bt_node", "path_expiring_timer_condition",
    "distance_traveled_condition_bt_node", "single_trigger_bt_node", "goal_updated_controller_bt_node",
    "is_battery_low_condition_bt_node", "navigate_through_poses_action_bt_node", "navigate_to_pose_action_bt_node",
    "remove_passed_goals_action_bt_node", "planner_selector_bt_node", "controller_selector_bt_node",
    "goal_checker_selector_bt_node", "controller_cancel_bt_node", "path_longer_on_approach_bt_node", "wait_cancel_bt_node",
    "spin_cancel_bt_node", "assisted_teleop_cancel_bt_node", "back_up_cancel_bt_node", "drive_on_heading_cancel_bt_node",
)  # fmt: skip
