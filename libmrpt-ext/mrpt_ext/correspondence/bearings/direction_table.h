#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/scan_bearing.h"

namespace mrpt_ext
{
/// The bearings of one scan as a lookup table: for a direction and a width of the gate, the set of bearings (one
/// bit each) that a landmark in that direction may match.
///
/// Directions are binned by the pseudo-angle y / (|x| + |y|), which costs a division and no trigonometry. Widths
/// come in steps of a factor 2 or 1.5 of the variance; the sets of a step hold for its upper end, and for the whole
/// bin, so that no bearing within its gate is missed.
class DirectionTable
{
 public:
  static constexpr std::size_t kMaxBearings = 32;      ///< further ones are not looked up
  static constexpr int kStepBits = 1;                  ///< of a float's mantissa: steps per factor 2 of the variance
  static constexpr int kShift = 23 - kStepBits;        ///< from a float's bits to its step
  static constexpr int kFirstStep = 127 << kStepBits;  ///< step of the float 1

  /// `bearings`: of one scan. `gate` [standard deviations].
  DirectionTable(std::span<const ScanBearing> bearings, double gate);

  [[nodiscard]] int size() const { return size_; }  ///< bearings looked up
  [[nodiscard]] float inverseVariance() const { return inverse_variance_; }
  [[nodiscard]] int bins() const { return bins_; }
  [[nodiscard]] int levels() const { return levels_; }
  [[nodiscard]] const std::uint32_t* sets() const { return sets_.data(); }               ///< [level * bins + bin]
  [[nodiscard]] const std::uint32_t* ofCategory() const { return of_category_.data(); }  ///< [category, modulo 256]
  /// Bearings that landmarks of this or a later category may match [category, modulo 256].
  [[nodiscard]] const std::uint32_t* fromCategory() const { return from_category_.data(); }
  [[nodiscard]] bool hasCategories() const { return has_categories_; }
  [[nodiscard]] const ScanBearing& bearing(int bit) const { return bearings_[static_cast<std::size_t>(bit)]; }

 private:
  void addBearing(std::uint32_t bit, double bearing, double half_width, std::uint32_t* level) const;

  int size_ = 0, bins_ = 0, levels_ = 0;
  float inverse_variance_ = 0;
  bool has_categories_ = false;
  std::vector<std::uint32_t> sets_, of_category_, from_category_;
  std::vector<ScanBearing> bearings_;
};
}  // namespace mrpt_ext
