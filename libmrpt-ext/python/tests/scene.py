"""A robot on a circle in a room with four landmarks in its corners."""

import numpy as np

CORNERS = np.array([[0.0, 0.0], [6.0, 0.0], [6.0, 5.0], [0.0, 5.0]])


def wrap(angle):
    return np.arctan2(np.sin(angle), np.cos(angle))


def truth_at(t):
    a, radius = 0.4 * t, 0.5 / 0.4
    return np.array([3 + radius * np.sin(a), 1.2 + radius * (1 - np.cos(a)), wrap(a)])


def bearings_at(pose, landmarks=CORNERS):
    to = np.asarray(landmarks) - pose[:2]
    return wrap(np.arctan2(to[:, 1], to[:, 0]) - pose[2])


def ranges_at(pose, landmarks=CORNERS):
    return np.linalg.norm(np.asarray(landmarks) - pose[:2], axis=1)
