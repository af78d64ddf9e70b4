import threading

import mrpt_ext
import numpy as np
import pytest
from scene import CORNERS, bearings_at, truth_at, wrap


def detections_at(t):
    return [{"id": i, "bearing": b, "std_bearing": 0.02} for i, b in enumerate(bearings_at(truth_at(t)))]


def robot(**options):
    return mrpt_ext.OnlineLocalizer(mrpt_ext.LandmarkMap(CORNERS), particles=500, initial_particles=4000, **options)


def drive(localizer, until=6.0):
    for k in range(int(10 * until) + 1):
        localizer.add_odometry(k / 10, truth_at(k / 10))
        localizer.add_detections(k / 10, "camera", detections_at(k / 10))


def test_it_localizes():
    localizer = robot()
    assert localizer.pose_at(0) is None
    drive(localizer)
    estimates = localizer.estimates() + localizer.finish()
    assert len(estimates) == 61
    last = estimates[-1]
    assert last["verdict"] == "ok" and last["t"] == 6
    assert np.linalg.norm(last["pose"][:2] - truth_at(6)[:2]) < 0.1
    assert abs(wrap(last["pose"][2] - truth_at(6)[2])) < 0.05
    assert last["covariance"].shape == (3, 3)
    now = localizer.pose_at(6)
    assert np.allclose(now["pose"], last["pose"])
    assert localizer.unusable == {}


def test_what_a_step_is_too_short_for_comes_later():
    localizer, patient = robot(step_budget_ms=0.5), robot(step_budget_ms=0)
    drive(localizer, until=2)
    estimates = localizer.estimates()
    while localizer.working():
        estimates += localizer.estimates()
    assert not localizer.working()
    estimates += localizer.finish()
    drive(patient, until=2)
    expected = patient.estimates() + patient.finish()
    assert [e["t"] for e in estimates] == [e["t"] for e in expected]
    assert any(e["steps_late"] > 0 and "late" in e["reason"] for e in estimates)
    assert all(e["steps_late"] == 0 for e in expected)
    assert np.array_equal(estimates[-1]["pose"], expected[-1]["pose"])


def test_mistakes_are_errors():
    localizer = robot()
    with pytest.raises(ValueError, match="standard deviation"):
        localizer.add_detections(0, "camera", [{"bearing": 0.1}])
    with pytest.raises(KeyError, match="speed"):
        localizer.add_detections(0, "camera", [{"bearing": 0.1, "std_bearing": 0.1, "speed": 3}])
    with pytest.raises(mrpt_ext.InputError):
        localizer.add_odometry(0, [1e200, 0, 0])
    with pytest.raises(mrpt_ext.InputError, match="snapshot"):
        localizer.restore("something else")
    with pytest.raises(mrpt_ext.InputError, match="no such file"):
        mrpt_ext.LandmarkMap.load("/no/such/map.csv")


def test_one_tag_that_faces_a_known_direction_tells_the_heading():
    tag = {"id": 0, "bearing": 0.2, "std_bearing": 0.002, "range": 3.0, "std_range": 0.02}
    seen = dict(tag, yaw=np.pi, std_yaw=0.03)
    for detection, known in ((tag, False), (seen, True)):
        localizer = mrpt_ext.OnlineLocalizer(
            mrpt_ext.LandmarkMap([[5.0, 1.0], [0.0, 4.0]], yaws=[np.pi, np.nan]), particles=500, initial_particles=4000)
        localizer.add_odometry(0, [0, 0, 0])
        localizer.add_detections(0, "camera", [detection])
        best = (localizer.estimates() + localizer.finish())[-1]["modes"][0]
        assert (best["weight"] > 0.9) == known
        if known:  # facing the tag, which is seen 0.2 rad to the left
            np.testing.assert_allclose(best["pose"], [5 - 3 * np.cos(0.2), 1 - 3 * np.sin(0.2), 0], atol=0.1)
    with pytest.raises(ValueError, match="yaw"):
        localizer.add_detections(0, "camera", [dict(tag, yaw=1.0)])


def test_snapshot_and_reset():
    localizer = robot()
    drive(localizer)
    localizer.finish()
    another = robot()
    another.restore(localizer.snapshot())
    another.add_odometry(0, [0, 0, 0])
    another.add_detections(0, "camera", detections_at(6)[:1])
    estimate = another.finish()[0]
    assert np.linalg.norm(estimate["pose"][:2] - truth_at(6)[:2]) < 0.1
    third = robot()
    third.reset(0, truth_at(0), np.diag([0.01, 0.01, 0.001]))
    third.add_detections(0, "camera", detections_at(0)[:1])
    assert np.linalg.norm(third.finish()[0]["pose"][:2] - truth_at(0)[:2]) < 0.3


def test_other_threads_run_meanwhile():
    localizer = robot()
    drive(localizer)
    counts = []
    worker = threading.Thread(target=lambda: counts.append(len(localizer.estimates())))
    worker.start()
    worker.join()
    assert counts[0] + len(localizer.finish()) == 61
