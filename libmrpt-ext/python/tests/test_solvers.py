import mrpt_ext
import numpy as np
import pytest
from scene import CORNERS, bearings_at, ranges_at, truth_at, wrap

TRUTH = truth_at(1.3)


def expect_pose(pose, truth=TRUTH, within=1e-6):
    assert np.allclose(pose[:2], truth[:2], atol=within)
    assert abs(wrap(pose[2] - truth[2])) < within


def test_bearings_give_the_pose():
    bearings = bearings_at(TRUTH)
    linear = mrpt_ext.bearing_pose_linear(CORNERS, bearings)
    assert linear["status"] == "ok"
    expect_pose(linear["pose"])
    likely = mrpt_ext.bearing_pose_ml(CORNERS, bearings, 0.01)
    expect_pose(likely["pose"])
    assert likely["covariance"].shape == (3, 3)
    bound = mrpt_ext.pose_bound(TRUTH, CORNERS, 0.01)
    assert np.allclose(likely["covariance"], bound, rtol=1e-6)


def test_too_few_is_a_status_and_a_wrong_shape_an_error():
    assert mrpt_ext.bearing_pose_linear(CORNERS[:2], [0.1, 0.2])["status"] == "too_few"
    assert mrpt_ext.pose_bound(TRUTH, CORNERS[:1], 0.01) is None
    with pytest.raises(ValueError, match="as many landmarks"):
        mrpt_ext.bearing_pose_ml(CORNERS, [0.1, 0.2], 0.01)
    with pytest.raises(ValueError, match="as many landmarks"):
        mrpt_ext.bearing_pose_ml(CORNERS, [0.1, 0.2, 0.3, 0.4], [0.01, 0.01])


def test_two_ranges_leave_a_mirror_image():
    found = mrpt_ext.range_position(CORNERS[:2], ranges_at(TRUTH, CORNERS[:2]), 0.05)
    assert found["status"] == "ok"
    assert sorted(round(candidate["position"][1], 6) for candidate in found["candidates"]) == pytest.approx(
        sorted([TRUTH[1], -TRUTH[1]]), abs=1e-5
    )


def test_running_fix_has_two_candidates():
    first, second = truth_at(0)[:2], truth_at(2)[:2]
    ranges = [np.linalg.norm(CORNERS[2] - at) for at in (first, second)]
    fix = mrpt_ext.running_fix(CORNERS[2], second - first, *ranges, 0.05, 0.05)
    assert fix["status"] == "ok" and len(fix["candidates"]) == 2
    assert min(np.linalg.norm(candidate["second"] - second) for candidate in fix["candidates"]) < 1e-9


def test_mixed_measurements():
    found = mrpt_ext.solve_pose(
        CORNERS[:2], bearings_at(TRUTH, CORNERS[:2]), 0.01, CORNERS[2:3], ranges_at(TRUTH, CORNERS[2:3]), 0.05
    )
    assert found["status"] == "ok"
    expect_pose(found["candidates"][0]["pose"], within=1e-5)


def test_statistics_agree_with_the_bound():
    random, std, errors = np.random.default_rng(7), 0.01, []
    for _ in range(400):
        noisy = bearings_at(TRUTH) + std * random.standard_normal(4)
        errors.append(mrpt_ext.bearing_pose_ml(CORNERS, noisy, std)["pose"][:2] - TRUTH[:2])
    bound = mrpt_ext.pose_bound(TRUTH, CORNERS, std)
    ratio = np.trace(np.cov(np.array(errors).T)) / np.trace(bound[:2, :2])
    assert 0.8 < ratio < 1.25


def test_anonymous_search_finds_the_pose():
    random = np.random.default_rng(3)
    landmarks = random.uniform(0, 40, (60, 2))
    search = mrpt_ext.PoseSearch(mrpt_ext.LandmarkMap(landmarks))
    truth = np.array([18.0, 22.0, 0.7])
    near = np.argsort(ranges_at(truth, landmarks))[:6]
    found = search.find(bearings_at(truth, landmarks[near]), 0.003, ranges_at(truth, landmarks[near]), 0.03, max_range=15)
    assert found["status"] == "ok" and found["finished"]
    expect_pose(found["poses"][0]["pose"], truth, within=0.02)
    assert list(found["poses"][0]["assignment"]) == list(near)
