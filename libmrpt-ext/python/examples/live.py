"""A robot drives a circle and sees one landmark after the other; the filter is not told where it starts."""

import mrpt_ext
import numpy as np

corners = np.array([[0, 0], [6, 0], [6, 5], [0, 5]], dtype=float)
robot = mrpt_ext.OnlineLocalizer(mrpt_ext.LandmarkMap(corners))
for k in range(60):
    t, heading, seen = 0.2 * k, np.deg2rad(6) * k, k % 4
    place = np.array([3 + np.sin(heading), 1.5 - np.cos(heading)])
    to = corners[seen] - place
    robot.add_velocity(t, v=np.deg2rad(30), omega=np.deg2rad(30))
    robot.add_detections(t, "camera", [{"id": seen, "bearing": np.arctan2(to[1], to[0]) - heading, "std_bearing": 0.02}])
    for estimate in robot.estimates():
        if "pose" in estimate and k % 5 == 0:
            x, y, phi = estimate["pose"]
            print(f"{estimate['t']:4.1f} s  {estimate['verdict']:9}  x {x:5.2f}  y {y:5.2f}  phi {np.rad2deg(phi):6.1f} deg")
