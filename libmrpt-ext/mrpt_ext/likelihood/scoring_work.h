#pragma once

#include <optional>

#include "mrpt_ext/geometry/bounded_frame.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/likelihood/pose_batch.h"

namespace mrpt_ext
{
/// Densities (of a detection, for a landmark, at a robot; one takes about a nanosecond) in one weighting at most.
inline constexpr double kMostDensities = 1e8;

/// Share of the map that may be in range of a sensor on robots within such an extent [m], if landmarks stand everywhere
/// in the bounding box of the map.
[[nodiscard]] double shareInRange(const SensorModel& model, const LandmarkTable& map, const Vector2d& extent);

/// Landmarks, on average over the robots, that one anonymous detection is compared with. Robots next to each other in
/// the batch are scored together (reading_scorer.h): of those close together few landmarks are within range and in the
/// direction of the detection, of those all over the map every landmark may be. An estimate from the extents of blocks.
[[nodiscard]] double landmarksCompared(const SensorModel& model, const LandmarkTable& map, const PoseBatch& robots);

/// Densities of all detections of the frame for all robots, and what takes as long: a landmark near the edge of the
/// view costs as much as several, and to leave a landmark out costs something too. Few robots cost as much as a tile of
/// them (sensor_tile.h).
[[nodiscard]] double scoringWork(const Frame& frame, const LandmarkTable& map, const PoseBatch& robots);

/// The frame with fewer detections (bounded_frame.h), so that all robots can be scored with `most` densities; nothing
/// for a frame that can be scored as it is.
[[nodiscard]] std::optional<Frame> affordableToScore(const Frame& frame, const LandmarkTable& map,
                                                     const PoseBatch& robots, double most = kMostDensities);

/// How many robots, spread as these, can be scored with `most` densities, if that takes no more than `detections` of
/// the frame: no more than there are.
[[nodiscard]] std::size_t affordableRobots(const Frame& frame, const LandmarkTable& map, const PoseBatch& robots,
                                           std::size_t detections, double most = kMostDensities);
}  // namespace mrpt_ext
