"""How good are linear form and maximum likelihood, against the Cramer-Rao bound?"""

import mrpt_ext
import numpy as np

random = np.random.default_rng(1)
landmarks = np.array([[0, 0], [6, 0], [6, 5], [0, 5], [3, 7]], dtype=float)
truth = np.array([2.0, 1.5, 0.4])
to = landmarks - truth[:2]
bearings = np.arctan2(to[:, 1], to[:, 0]) - truth[2]
print(" std    linear   likelihood   bound  (RMS position error)")
for degrees in (0.1, 0.5, 1.0, 2.0):
    std, errors = np.deg2rad(degrees), {"linear": [], "ml": []}
    for _ in range(1000):
        noisy = bearings + std * random.standard_normal(len(bearings))
        answers = {"linear": mrpt_ext.bearing_pose_linear(landmarks, noisy), "ml": mrpt_ext.bearing_pose_ml(landmarks, noisy, std)}
        for name, answer in answers.items():
            if answer["status"] == "ok":
                errors[name].append(np.sum((answer["pose"][:2] - truth[:2]) ** 2))
    bound = mrpt_ext.pose_bound(truth, landmarks, std)
    rms = {name: np.sqrt(np.mean(squares)) for name, squares in errors.items()}
    print(f"{degrees:4.1f}   {rms['linear']:7.4f}   {rms['ml']:9.4f}   {np.sqrt(np.trace(bound[:2, :2])):7.4f}")
