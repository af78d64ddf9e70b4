"""Landmark localization: where is a robot that sees known landmarks?

OnlineLocalizer     the particle filter while things happen
PoseSearch          every pose that a scan of anonymous landmarks allows
solve_pose, ...     closed forms and maximum likelihood of single frames, their covariances and the Cramer-Rao bound
run, load_run       a whole log, and what a run has left as arrays

Lengths are metres, angles radians counter-clockwise, poses arrays (x, y, phi).
"""

from ._native import (
    InputError,
    LandmarkMap,
    OnlineLocalizer,
    PoseSearch,
    __version__,
    bearing_pose_linear,
    bearing_pose_ml,
    pose_bound,
    range_position,
    running_fix,
    solve_pose,
)
from .runs import Run, load_run, run

__all__ = [
    "InputError",
    "LandmarkMap",
    "OnlineLocalizer",
    "PoseSearch",
    "Run",
    "bearing_pose_linear",
    "bearing_pose_ml",
    "load_run",
    "pose_bound",
    "range_position",
    "run",
    "running_fix",
    "solve_pose",
]
