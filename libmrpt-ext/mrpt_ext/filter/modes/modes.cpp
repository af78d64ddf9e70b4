#include "mrpt_ext/filter/modes/modes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mrpt_ext/filter/modes/pose_histogram.h"
#include "mrpt_ext/filter/particles/particle_blocks.h"
#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
namespace
{
constexpr int kNoLabel = -1;
// In operations (work_counter.h): of a particle; of a cell; of asking for the neighbours of one.
constexpr std::size_t kCostOfParticle = 100, kCostOfCell = 300, kCostOfNeighbours = 700;
constexpr double kCoreShare = 0.05;  // of the heaviest cell; lighter cells separate modes
constexpr double kCompactStdXy = 0.5, kCompactStdPhi = degToRad(20.0);  // of a compact mode

/// Labels connected heavy cells; returns the number of labels.
int labelCores(const PoseHistogram& grid, double threshold, std::vector<int>& label)
{
  int labels = 0;
  std::vector<std::size_t> open;
  for (std::size_t start = 0; start < grid.size(); ++start)
  {
    if (label[start] != kNoLabel || grid.weight(start) < threshold) continue;
    open.assign(1, start);
    label[start] = labels;
    while (!open.empty())
    {
      const std::size_t cell = open.back();
      open.pop_back();
      WorkCounter::add(kCostOfNeighbours);
      grid.forNeighbours(cell,
                         [&](std::size_t next)
                         {
                           if (label[next] != kNoLabel || grid.weight(next) < threshold) return;
                           label[next] = labels;
                           open.push_back(next);
                         });
    }
    ++labels;
  }
  return labels;
}

/// Gives light cells, heaviest first, the label of their heaviest labelled neighbour, or a label of their own.
int labelRest(const PoseHistogram& grid, int labels, std::vector<int>& label)
{
  std::vector<std::size_t> order(grid.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return grid.weight(a) > grid.weight(b); });
  for (const std::size_t cell : order)
  {
    if (label[cell] != kNoLabel) continue;
    WorkCounter::add(kCostOfNeighbours);
    double best = -1;
    grid.forNeighbours(cell,
                       [&](std::size_t next)
                       {
                         if (label[next] == kNoLabel || grid.weight(next) <= best) return;
                         best = grid.weight(next);
                         label[cell] = label[next];
                       });
    if (label[cell] == kNoLabel) label[cell] = labels++;
  }
  return labels;
}

/// Mean heading of some cells: the angle of the sum of the unit vectors of their mean headings, and what the mean of
/// the differences from it adds.
double meanHeading(const PoseHistogram& grid, const std::vector<std::size_t>& cells, double weight)
{
  double c = 0, s = 0;
  for (const std::size_t cell : cells)
  {
    const CellMoments moments = grid.moments(cell);
    if (!(moments.weight > 0)) continue;
    const double heading = grid.middle(cell).phi + moments.first.z() / moments.weight;
    c += moments.weight * std::cos(heading);
    s += moments.weight * std::sin(heading);
  }
  const double about = std::atan2(s, c);
  double difference = 0;
  for (const std::size_t cell : cells)
  {
    const CellMoments moments = grid.moments(cell);
    difference += moments.weight * wrap(grid.middle(cell).phi - about) + moments.first.z();
  }
  return wrap(about + difference / weight);
}

/// From the moments of the cells, moved to the common mean.
Mode describe(const PoseHistogram& grid, const std::vector<std::size_t>& cells)
{
  Mode mode;
  Vector2d position = Vector2d::Zero();
  for (const std::size_t cell : cells)
  {
    const CellMoments moments = grid.moments(cell);
    mode.weight += moments.weight;
    position += moments.weight * grid.middle(cell).position() + moments.first.head<2>();
  }
  if (!(mode.weight > 0)) return mode;
  position /= mode.weight;
  mode.pose.mean = {position.x(), position.y(), meanHeading(grid, cells, mode.weight)};
  for (const std::size_t cell : cells)
  {
    const CellMoments m = grid.moments(cell);
    Vector3d d = grid.middle(cell).vector() - mode.pose.mean.vector();
    d.z() = wrap(d.z());
    const Matrix3d cross = d * m.first.transpose();
    mode.pose.covariance += (m.second + cross + cross.transpose() + m.weight * d * d.transpose()) / mode.weight;
  }
  for (int i = 0; i < 3; ++i)  // differences of rounded sums
    mode.pose.covariance(i, i) = std::max(0.0, mode.pose.covariance(i, i));
  return mode;
}
}  // namespace

bool isCompact(const Mode& mode)
{
  const Matrix3d& C = mode.pose.covariance;
  return C(0, 0) + C(1, 1) < square(kCompactStdXy) && C(2, 2) < square(kCompactStdPhi);
}

ModeSet findModes(const ParticleSet& particles, const ModeOptions& options, unsigned threads, std::vector<int> buffer)
{
  ModeSet result;
  if (particles.empty()) return result;
  WorkCounter::add(kCostOfParticle * particles.size());
  PoseHistogram grid(particles, options.cell_xy, options.cell_phi, threads, std::move(buffer));
  WorkCounter::add(kCostOfCell * grid.size());
  double heaviest = 0;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) heaviest = std::max(heaviest, grid.weight(cell));
  std::vector<int> label(grid.size(), kNoLabel);
  const int labels = labelRest(grid, labelCores(grid, kCoreShare * heaviest, label), label);

  std::vector<std::vector<std::size_t>> cells(static_cast<std::size_t>(labels));
  for (std::size_t cell = 0; cell < grid.size(); ++cell) cells[static_cast<std::size_t>(label[cell])].push_back(cell);
  std::vector<Mode> modes(cells.size());
  std::transform(cells.begin(), cells.end(), modes.begin(),
                 [&](const auto& members) { return describe(grid, members); });

  std::vector<std::size_t> order(cells.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return modes[a].weight > modes[b].weight; });
  std::vector<int> rank_of(grid.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank)
  {
    result.modes.push_back(modes[order[rank]]);
    for (const std::size_t cell : cells[order[rank]]) rank_of[cell] = static_cast<int>(rank);
  }
  result.mode_of = std::move(grid).labelParticles(rank_of, threads);
  return result;
}
}  // namespace mrpt_ext
