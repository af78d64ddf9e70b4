#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/bearing_reading.h"
#include "mrpt_ext/correspondence/triple_pose.h"
#include "mrpt_ext/correspondence/visible_lists.h"

namespace mrpt_ext
{
/// The readings of one place as a table to look landmarks up in: for a direction and a width of the gate, the set of
/// readings (one bit each) that a landmark seen there would explain.
///
/// Directions are binned by the pseudo-angle y / (|x| + |y|), which costs a division and no trigonometry. Widths come
/// in steps of a factor 2 or 1.5 of the variance; each step's sets hold for its upper end, and for the whole bin, so
/// that no reading within its gate is ever missed.
class ReadingTable
{
 public:
  static constexpr std::size_t kMaxReadings = 32;  ///< further ones are not looked up

  /// `readings`: of one place. `gate` [standard deviations].
  ReadingTable(std::span<const BearingReading> readings, double gate);

  [[nodiscard]] int size() const { return size_; }  ///< readings looked up
  [[nodiscard]] float inverseVariance() const { return inverse_variance_; }
  [[nodiscard]] int bins() const { return bins_; }
  [[nodiscard]] int levels() const { return levels_; }
  [[nodiscard]] const std::uint32_t* sets() const { return sets_.data(); }       ///< [level * bins + bin]
  [[nodiscard]] const std::uint32_t* ofKind() const { return of_kind_.data(); }  ///< [kind, modulo 256]
  [[nodiscard]] bool hasKinds() const { return has_kinds_; }
  [[nodiscard]] const BearingReading& reading(int bit) const { return readings_[static_cast<std::size_t>(bit)]; }

  /// Step of a variance ratio (what the pose adds to the largest reading variance, plus one), as an index of a level.
  [[nodiscard]] int levelOf(float ratio) const;
  /// Readings that a landmark of this kind explains when it is seen in the direction (x, y), sensor's axes.
  [[nodiscard]] std::uint32_t explainedBy(float x, float y, float ratio, std::uint8_t kind) const;

 private:
  void addReading(std::uint32_t bit, double bearing, double half_width, std::uint32_t* level) const;

  int size_ = 0, bins_ = 0, levels_ = 0;
  float inverse_variance_ = 0;
  bool has_kinds_ = false;
  std::vector<std::uint32_t> sets_, of_kind_;
  std::vector<BearingReading> readings_;
};

/// A place to compare with: where its sensor is relative to the sensor whose poses are tested.
struct SieveView
{
  const ReadingTable* table = nullptr;
  const VisibleLists* lists = nullptr;
  Pose2 T_tested_sensor;
  std::uint32_t used = 0;  ///< readings that the tested poses explain by construction
};

/// For each pose an upper bound on the number of readings that it explains: readings with a landmark in the gate that
/// the pose's covariance gives it. Never too low for a pose within `gate` standard deviations of the truth, up to the
/// curvature of bearings. `around`: landmark i in the world.
void boundExplained(const TriplePoses& poses, const Vector2d& around, std::span<const SieveView> views, double gate,
                    std::vector<std::uint8_t>& explained);
}  // namespace mrpt_ext
