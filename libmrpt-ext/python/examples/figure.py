"""A log to a figure: estimated and dead-reckoned trajectory of the shipped data set `room`."""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import mrpt_ext

above = Path(__file__).resolve().parents[3]  # the source tree, or /usr/share with the packages installed
source = next(folder for folder in (above, above / "mrpt_ext") if (folder / "ini").is_dir())
done = mrpt_ext.run(source / "ini/landmark-localization/quickstart.ini", "room-run", options=["--duration", "30"])
landmarks = mrpt_ext.LandmarkMap.load(str(source / "datasets/room_map.csv")).positions
figure, axes = plt.subplots()
axes.plot(landmarks[:, 0], landmarks[:, 1], "k^", label="landmarks")
for name in ("particle_filter", "odometry"):
    axes.plot(*done.trajectories[name][:, 1:3].T, label=name)
axes.set(aspect="equal", xlabel="x [m]", ylabel="y [m]", title=f"verdict: {done.summary['verdict']}")
axes.legend()
figure.savefig("room.png", dpi=120)
print("wrote room.png")
