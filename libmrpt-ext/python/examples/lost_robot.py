"""A lost robot among 200 landmarks that all look alike: every pose that one scan allows."""

import mrpt_ext
import numpy as np

random = np.random.default_rng(1)
landmarks = random.uniform(0, 60, (200, 2))
truth = np.array([31.0, 24.0, 1.2])
to = landmarks - truth[:2]
ranges = np.hypot(*to.T)
seen = ranges < 10
bearings = np.arctan2(to[seen, 1], to[seen, 0]) - truth[2] + 0.003 * random.standard_normal(seen.sum())
found = mrpt_ext.PoseSearch(mrpt_ext.LandmarkMap(landmarks)).find(
    bearings, 0.003, ranges[seen] + 0.03 * random.standard_normal(seen.sum()), 0.03, max_range=10
)
print(f"{seen.sum()} detections, {len(found['poses'])} poses, unique: {found['unique']}")
for pose in found["poses"][:3]:
    print("x {:.2f}  y {:.2f}  phi {:.3f}".format(*pose["pose"]), f" probability {pose['probability']:.3f}")
