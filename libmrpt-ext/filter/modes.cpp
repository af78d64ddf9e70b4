#include "mrpt_ext/filter/modes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

namespace mrpt_ext
{
namespace
{
using Cell = std::array<std::int64_t, 3>;

struct CellHash
{
  std::size_t operator()(const Cell& c) const
  {
    const auto mix = [](std::uint64_t v) { return (v ^ (v >> 29)) * 0xbf58476d1ce4e5b9ULL; };
    return mix(static_cast<std::uint64_t>(c[0]) +
               mix(static_cast<std::uint64_t>(c[1]) + mix(static_cast<std::uint64_t>(c[2]))));
  }
};

/// Occupied cells in order of first appearance (deterministic), with weights and neighbour look-up.
class CellGrid
{
 public:
  CellGrid(const ParticleSet& particles, const ModeOptions& options)
      : turns_(std::max<std::int64_t>(1, std::llround(kTwoPi / options.cell_phi)))
  {
    cell_of_.reserve(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
      const Pose2 pose = particles.pose(i);
      const double turned = (pose.phi + kPi) / kTwoPi * static_cast<double>(turns_);
      const Cell cell{static_cast<std::int64_t>(std::floor(pose.x / options.cell_xy)),
                      static_cast<std::int64_t>(std::floor(pose.y / options.cell_xy)),
                      static_cast<std::int64_t>(std::floor(turned)) % turns_};
      const auto [entry, fresh] = index_.try_emplace(cell, cells_.size());
      if (fresh)
      {
        cells_.push_back(cell);
        weight_.push_back(0);
      }
      weight_[entry->second] += std::exp(double{particles.log_weight[i]});
      cell_of_.push_back(entry->second);
    }
  }

  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] double weight(std::size_t cell) const { return weight_[cell]; }
  [[nodiscard]] const std::vector<std::size_t>& cellOf() const { return cell_of_; }

  template <typename Visit>
  void forNeighbours(std::size_t cell, Visit&& visit) const
  {
    const Cell& c = cells_[cell];
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        for (std::int64_t dphi = -1; dphi <= 1; ++dphi)
        {
          const auto found = index_.find({c[0] + dx, c[1] + dy, (c[2] + dphi + turns_) % turns_});
          if (found != index_.end() && found->second != cell) visit(found->second);
        }
  }

 private:
  std::int64_t turns_;
  std::unordered_map<Cell, std::size_t, CellHash> index_;
  std::vector<Cell> cells_;
  std::vector<double> weight_;
  std::vector<std::size_t> cell_of_;
};

constexpr int kNone = -1;

/// Labels connected heavy cells; returns the number of labels.
int labelCores(const CellGrid& grid, double threshold, std::vector<int>& label)
{
  int labels = 0;
  std::vector<std::size_t> open;
  for (std::size_t start = 0; start < grid.size(); ++start)
  {
    if (label[start] != kNone || grid.weight(start) < threshold) continue;
    open.assign(1, start);
    label[start] = labels;
    while (!open.empty())
    {
      const std::size_t cell = open.back();
      open.pop_back();
      grid.forNeighbours(cell,
                         [&](std::size_t next)
                         {
                           if (label[next] != kNone || grid.weight(next) < threshold) return;
                           label[next] = labels;
                           open.push_back(next);
                         });
    }
    ++labels;
  }
  return labels;
}

/// Gives light cells, heaviest first, the label of their heaviest labelled neighbour, or a label of their own.
int labelRest(const CellGrid& grid, int labels, std::vector<int>& label)
{
  std::vector<std::size_t> order(grid.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return grid.weight(a) > grid.weight(b); });
  for (const std::size_t cell : order)
  {
    if (label[cell] != kNone) continue;
    double best = -1;
    grid.forNeighbours(cell,
                       [&](std::size_t next)
                       {
                         if (label[next] == kNone || grid.weight(next) <= best) return;
                         best = grid.weight(next);
                         label[cell] = label[next];
                       });
    if (label[cell] == kNone) label[cell] = labels++;
  }
  return labels;
}

Mode describe(const ParticleSet& particles, const std::vector<std::size_t>& members)
{
  double weight = 0, x = 0, y = 0, c = 0, s = 0;
  for (const std::size_t i : members)
  {
    const double w = std::exp(double{particles.log_weight[i]});
    weight += w;
    x += w * double{particles.x[i]};
    y += w * double{particles.y[i]};
    c += w * std::cos(double{particles.phi[i]});
    s += w * std::sin(double{particles.phi[i]});
  }
  Mode mode;
  mode.weight = weight;
  if (!(weight > 0)) return mode;
  mode.pose.mean = {particles.origin.x() + x / weight, particles.origin.y() + y / weight, std::atan2(s, c)};
  for (const std::size_t i : members)
  {
    Vector3d d = particles.pose(i).vector() - mode.pose.mean.vector();
    d.z() = wrap(d.z());
    mode.pose.covariance += std::exp(double{particles.log_weight[i]}) / weight * d * d.transpose();
  }
  return mode;
}
}  // namespace

ModeSet findModes(const ParticleSet& particles, const ModeOptions& options)
{
  ModeSet result;
  if (particles.empty()) return result;
  const CellGrid grid(particles, options);
  double heaviest = 0;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) heaviest = std::max(heaviest, grid.weight(cell));
  std::vector<int> label(grid.size(), kNone);
  const int labels = labelRest(grid, labelCores(grid, options.core_share * heaviest, label), label);

  std::vector<std::vector<std::size_t>> members(static_cast<std::size_t>(labels));
  for (std::size_t i = 0; i < particles.size(); ++i)
    members[static_cast<std::size_t>(label[grid.cellOf()[i]])].push_back(i);
  std::vector<Mode> modes(members.size());
  std::transform(members.begin(), members.end(), modes.begin(), [&](const auto& m) { return describe(particles, m); });

  std::vector<std::size_t> order(members.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return modes[a].weight > modes[b].weight; });
  result.mode_of.resize(particles.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank)
  {
    result.modes.push_back(modes[order[rank]]);
    for (const std::size_t i : members[order[rank]]) result.mode_of[i] = static_cast<int>(rank);
  }
  return result;
}
}  // namespace mrpt_ext
