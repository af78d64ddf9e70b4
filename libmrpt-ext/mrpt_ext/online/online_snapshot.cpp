#include "mrpt_ext/online/online_snapshot.h"

#include <sstream>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
const std::string kFormat = "mrpt_ext-snapshot", kVersion = "1";

/// The words of a snapshot, one after the other.
class SnapshotWords
{
 public:
  explicit SnapshotWords(const std::string& text) : words_(text) {}

  double number()
  {
    const auto value = parseNumber(word());
    if (!value) throw dataError("snapshot: '" + word_ + "', expected a number");
    return *value;
  }
  std::size_t count(std::size_t most)
  {
    const auto value = parseInteger(word());
    if (!value || *value < 0 || static_cast<std::size_t>(*value) > most)
      throw dataError("snapshot: '" + word_ + "', expected a number of entries");
    return static_cast<std::size_t>(*value);
  }
  void expect(const std::string& wanted)
  {
    if (word() != wanted) throw dataError("snapshot: '" + word_ + "', expected '" + wanted + "'");
  }
  void expectEnd()
  {
    if (words_ >> word_) throw dataError("snapshot: '" + word_ + "', expected its end");
  }

 private:
  const std::string& word()
  {
    if (!(words_ >> word_)) throw dataError("snapshot: it is cut off");
    return word_;
  }

  std::istringstream words_;
  std::string word_;
};
}  // namespace

std::string textOf(const OnlineSnapshot& snapshot)
{
  std::string text = kFormat + ' ' + kVersion;
  const auto add = [&](double value) { text += ' ' + shortestText(value); };
  add(snapshot.pose ? 1 : 0);
  if (snapshot.pose)
  {
    const auto& [mean, covariance] = *snapshot.pose;
    for (const double value : {mean.x, mean.y, mean.phi}) add(value);
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) add(covariance(i, j));
  }
  add(static_cast<double>(snapshot.biases.size()));
  for (const BiasEstimate& bias : snapshot.biases)
  {
    add(bias.mean);
    add(bias.std);
  }
  return text;
}

OnlineSnapshot snapshotFrom(const std::string& text)
{
  constexpr std::size_t kMostBiases = 1000;
  SnapshotWords words(text);
  words.expect(kFormat);
  words.expect(kVersion);
  OnlineSnapshot snapshot;
  if (words.count(1) == 1)
  {
    GaussianPose& pose = snapshot.pose.emplace();
    for (double* value : {&pose.mean.x, &pose.mean.y, &pose.mean.phi}) *value = words.number();
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) pose.covariance(i, j) = pose.covariance(j, i) = words.number();
  }
  snapshot.biases.resize(words.count(kMostBiases));
  for (BiasEstimate& bias : snapshot.biases)
  {
    bias.mean = words.number();
    bias.std = words.number();
  }
  words.expectEnd();
  return snapshot;
}
}  // namespace mrpt_ext
