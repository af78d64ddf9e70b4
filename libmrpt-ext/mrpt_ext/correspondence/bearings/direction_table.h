#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/scan_bearing.h"

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
  static constexpr std::size_t kMaxReadings = 32;      ///< further ones are not looked up
  static constexpr int kStepBits = 1;                  ///< of a float's mantissa: steps per factor 2 of the variance
  static constexpr int kShift = 23 - kStepBits;        ///< from a float's bits to its step
  static constexpr int kFirstStep = 127 << kStepBits;  ///< step of the float 1

  /// `readings`: of one place. `gate` [standard deviations].
  ReadingTable(std::span<const ScanBearing> readings, double gate);

  [[nodiscard]] int size() const { return size_; }  ///< readings looked up
  [[nodiscard]] float inverseVariance() const { return inverse_variance_; }
  [[nodiscard]] int bins() const { return bins_; }
  [[nodiscard]] int levels() const { return levels_; }
  [[nodiscard]] const std::uint32_t* sets() const { return sets_.data(); }       ///< [level * bins + bin]
  [[nodiscard]] const std::uint32_t* ofKind() const { return of_kind_.data(); }  ///< [kind, modulo 256]
  /// Readings that some kind from this one on explains [kind, modulo 256].
  [[nodiscard]] const std::uint32_t* fromKind() const { return from_kind_.data(); }
  [[nodiscard]] bool hasKinds() const { return has_kinds_; }
  [[nodiscard]] const ScanBearing& reading(int bit) const { return readings_[static_cast<std::size_t>(bit)]; }

 private:
  void addReading(std::uint32_t bit, double bearing, double half_width, std::uint32_t* level) const;

  int size_ = 0, bins_ = 0, levels_ = 0;
  float inverse_variance_ = 0;
  bool has_kinds_ = false;
  std::vector<std::uint32_t> sets_, of_kind_, from_kind_;
  std::vector<ScanBearing> readings_;
};
}  // namespace mrpt_ext
