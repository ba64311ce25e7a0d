"""The displays of the viewer, each modelled on RViz's display of the same name."""

from coursekit.nodes.rviz.config import DisplayConfig

from .axes import Axes
from .display import Display, NoTransform, NotYet
from .flat import GridCells, PointStamped, Polygon
from .grid import Grid
from .image import Image
from .map import Map
from .markers import Marker, MarkerArray
from .points import LaserScan, PointCloud, PointCloud2
from .poses import Odometry, ParticleCloud, Path, PoseArray, PoseStamped, PoseWithCovariance
from .range import Range
from .readings import FluidPressure, Illuminance, RelativeHumidity, Temperature
from .robot_model import RobotModel
from .screws import AccelStamped, TwistStamped, Wrench
from .tf import TF

_CLASSES: tuple[type[Display], ...] = (
    Grid, RobotModel, TF, Map, LaserScan, Path, PoseStamped, PoseArray, Odometry, Marker, MarkerArray, PointCloud2, Image,
    Axes, Polygon, PointStamped, GridCells, Range, Wrench, TwistStamped, AccelStamped, PointCloud, ParticleCloud,
    PoseWithCovariance, Temperature, RelativeHumidity, FluidPressure, Illuminance,
)  # fmt: skip
BY_KIND: dict[str, type[Display]] = {display.kind: display for display in _CLASSES}


def make_display(config: DisplayConfig, number: int) -> Display:
    """Make the display of a configuration; `number` is unique among the displays."""
    return BY_KIND[config.kind](config, number)


__all__ = ["BY_KIND", "Display", "NoTransform", "NotYet", "make_display"]
