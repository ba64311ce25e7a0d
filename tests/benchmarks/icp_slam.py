"""MRPT's icp-slam (Debian's mrpt-apps) on a log of the benchmark, for comparison; not perturbed.

Its converter gives all readings one time, so its odometry counts for nothing here: it matches every scan instead.
"""

import lzma
import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from coursekit.slam.relations import errors, read_relations

CONFIG = """
[MappingApplication]
rawlog_file = log.rawlog
rawlog_offset = 0
logOutput_dir = out
LOG_FREQUENCY = 1000000
GENERATE_LOG_JOINT_H = 0
GENERATE_LOG_INFO = 0
SAVE_MAP_IMAGES = 0
SAVE_3D_SCENE = 0
CAMERA_3DSCENE_FOLLOWS_ROBOT = 0
SAVE_POSE_LOG = 1
SHOW_PROGRESS_3D_REAL_TIME = 0
localizationLinDistance = 0
localizationAngDistance = 0
insertionLinDistance = 1.0
insertionAngDistance = 45
minICPgoodnessToAccept = 0.4
matchAgainstTheGrid = 0
occupancyGrid_count = 0
pointsMap_count = 1
[MappingApplication_pointsMap_00_insertOpts]
minDistBetweenLaserPoints = 0.05
fuseWithExisting = false
isPlanarMap = 1
[ICP]
ICP_algorithm = icpClassic
maxIterations = 80
minAbsStep_trans = 1e-6
minAbsStep_rot = 1e-6
thresholdDist = 0.3
thresholdAng_DEG = 5
ALFA = 0.8
smallestThresholdDist = 0.05
onlyUniqueRobust = true
corresponding_points_decimation = 5
"""


def icp_slam(log: Path, relations: Path) -> float | None:
    """Its mean translation error [m]; None where it is not installed."""
    if not (shutil.which("icp-slam") and shutil.which("carmen2rawlog")):
        return None
    with tempfile.TemporaryDirectory() as scratch:
        text = lzma.decompress(log.read_bytes())
        Path(scratch, "log.log").write_bytes(text)
        Path(scratch, "slam.ini").write_text(CONFIG, encoding="utf-8")
        for command in (["carmen2rawlog", "-q", "-w", "-i", "log.log", "-o", "log.rawlog"], ["icp-slam", "slam.ini"]):
            subprocess.run(command, cwd=scratch, capture_output=True, check=True)
        poses = np.loadtxt(Path(scratch, "out", "log_estimated_path.txt"))
    lines = [line.split() for line in text.decode().splitlines() if line.startswith(("FLASER", "ODOM"))]
    stamps = np.array([float(words[-1]) for words in lines])
    scans = [place for place, words in enumerate(lines) if words[0] == "FLASER" and place < len(poses)]
    return float(errors(np.column_stack([stamps[scans], poses[scans, 1:4]]), read_relations(relations)).translation)
