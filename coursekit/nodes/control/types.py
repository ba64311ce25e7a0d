"""The classes of controllers, by their names in parameter files."""

from __future__ import annotations

from .broadcasters import ImuBroadcaster, JointStateBroadcaster, RangeBroadcaster, WrenchBroadcaster
from .controller import Maker
from .diff_drive import DiffDriveController
from .forward import (
    EffortGroup,
    ForwardCommandController,
    MultiInterfaceForwardCommandController,
    PositionGroup,
    VelocityGroup,
)
from .gripper import GripperActionController
from .pid_controller import PidController
from .steering import AckermannSteeringController, BicycleSteeringController, TricycleSteeringController
from .trajectory_controller import JointTrajectoryController
from .tricycle import TricycleController

DRIVE = "diff_drive_controller/DiffDriveController"
TYPES: dict[str, Maker] = {
    "ackermann_steering_controller/AckermannSteeringController": AckermannSteeringController,
    "bicycle_steering_controller/BicycleSteeringController": BicycleSteeringController,
    DRIVE: DiffDriveController,
    "effort_controllers/JointGroupEffortController": EffortGroup,
    "effort_controllers/GripperActionController": GripperActionController,
    "force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster": WrenchBroadcaster,
    "forward_command_controller/ForwardCommandController": ForwardCommandController,
    "forward_command_controller/MultiInterfaceForwardCommandController": MultiInterfaceForwardCommandController,
    "imu_sensor_broadcaster/IMUSensorBroadcaster": ImuBroadcaster,
    "joint_state_broadcaster/JointStateBroadcaster": JointStateBroadcaster,
    "joint_trajectory_controller/JointTrajectoryController": JointTrajectoryController,
    "pid_controller/PidController": PidController,
    "position_controllers/GripperActionController": GripperActionController,
    "position_controllers/JointGroupPositionController": PositionGroup,
    "range_sensor_broadcaster/RangeSensorBroadcaster": RangeBroadcaster,
    "tricycle_controller/TricycleController": TricycleController,
    "tricycle_steering_controller/TricycleSteeringController": TricycleSteeringController,
    "velocity_controllers/JointGroupVelocityController": VelocityGroup,
}
__all__ = ["DRIVE", "TYPES"]
