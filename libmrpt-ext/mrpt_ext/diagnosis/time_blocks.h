#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace mrpt_ext
{
/// Sums over consecutive blocks of a stream, for standard errors of correlated data. Memory is constant: when there are
/// kMost blocks, neighbours are merged and blocks become twice as long. `Sum` has +=.
template <class Sum>
class TimeBlocks
{
 public:
  /// `zero`: an empty sum; `length`: items of a block at first.
  explicit TimeBlocks(Sum zero, std::size_t length = 1) : zero_(zero), open_(std::move(zero)), length_(length) {}

  /// Sum of the block in work.
  [[nodiscard]] Sum& open() { return open_; }
  /// An item is complete.
  void endItem()
  {
    if (++items_ < length_) return;
    complete_.push_back(std::exchange(open_, zero_));
    items_ = 0;
    if (complete_.size() < kMost) return;
    for (std::size_t k = 0; k < kMost / 2; ++k)
    {
      Sum pair = std::move(complete_[2 * k]);
      pair += complete_[2 * k + 1];
      complete_[k] = std::move(pair);
    }
    complete_.erase(complete_.begin() + kMost / 2, complete_.end());
    length_ *= 2;
  }
  /// The complete blocks.
  [[nodiscard]] const std::vector<Sum>& complete() const { return complete_; }

 private:
  static constexpr std::size_t kMost = 64;
  Sum zero_, open_;
  std::vector<Sum> complete_;
  std::size_t length_, items_ = 0;
};
}  // namespace mrpt_ext
