import os
from pathlib import Path

import mrpt_ext
import numpy as np
import pytest

SOURCE = Path(os.environ["MRPT_EXT_SOURCE"])
CONFIG = SOURCE / "ini/landmark-localization/quickstart.ini"
BRIEF = {
    "LocalizationExperiment.methods": "particle_filter,odometry",
    "LocalizationExperiment.particles_count": 200,
    "LocalizationExperiment.initial_particles_count": 2000,
}


def test_a_log_becomes_arrays(tmp_path):
    done = mrpt_ext.run(CONFIG, tmp_path / "run", overrides=BRIEF, options=["--duration", "6"])
    assert done.summary["schema"] == 1
    steps = done.steps["particle_filter"]
    count = len(steps["t"])
    assert count > 20
    assert steps["pose"].shape == (count, 3) and steps["covariance"].shape == (count, 2, 2)
    assert np.all(np.diff(steps["t"]) > 0)
    assert np.all(np.linalg.eigvalsh(steps["covariance"])[:, 0] > -1e-8)  # rounded in the file
    assert set(steps["verdict"]) <= {"ok", "ambiguous", "lost"}
    assert done.trajectories["odometry"].shape[1] == 4
    again = mrpt_ext.load_run(tmp_path / "run")
    assert np.array_equal(again.steps["particle_filter"]["pose"], steps["pose"])


def test_a_mistake_is_the_message_of_the_app(tmp_path):
    with pytest.raises(mrpt_ext.InputError, match="no such file"):
        mrpt_ext.run(CONFIG, tmp_path / "run", rawlog="nothing.rawlog")
    with pytest.raises(FileNotFoundError):
        mrpt_ext.load_run(tmp_path / "none")
