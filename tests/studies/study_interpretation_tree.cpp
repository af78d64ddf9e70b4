#include <ctime>
#include <iomanip>

#include "enumerated_interpretations.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
InterpretationOptions optionsFor(double sigma, int unmatched = 0, double margin = 0)
{
  InterpretationOptions options;
  options.max_residual = 3.3 * sigma;
  options.max_unmatched = unmatched;
  options.area = Box2{{-margin, -margin}, {10 + margin, 10 + margin}};
  return options;
}

void equality(std::ostream& out)
{
  out << "Against trying every ordered assignment, refined from 3 x 3 starts and the closed form (8 landmarks); scenes "
      << "with an assignment between 0.9 and 1.25 gates, or at the border, are left out:\n\n"
      << "| bearings | sigma [deg] | scenes compared | left out | solutions | scenes that differ "
         "|\n|---|---|---|---|---|---|\n";
  for (const auto& [seen, sigma_deg, wanted] :
       {std::tuple(4, 0.05, 50), std::tuple(4, 0.15, 20), std::tuple(5, 0.15, 20), std::tuple(5, 0.5, 10)})
  {
    RandomStream random(2000 + static_cast<std::uint64_t>(seen));
    const double sigma = degToRad(sigma_deg);
    int compared = 0, left_out = 0, differ = 0;
    std::size_t solutions = 0;
    while (compared < wanted)
    {
      const AnonymousScene s = observeAnonymously(random, 8, seen, 0, sigma);
      const InterpretationOptions options = optionsFor(sigma);
      const InterpretationEnumeration all(s, options, 3);
      if (all.doubtful)
      {
        ++left_out;
        continue;
      }
      ++compared;
      solutions += all.found.size();
      differ += assignmentsOf(interpretBearings(s.scene.landmarks, s.bearings, options)) != all.found ? 1 : 0;
    }
    out << "| " << seen << " | " << sigma_deg << " | " << compared << " | " << left_out << " | " << solutions << " | "
        << differ << " |\n";
  }
}

struct Trials
{
  double recall = 0, solutions = 0;
  std::vector<double> microseconds;

  Trials(int landmarks, int seen, int false_count, double sigma, InterpretationGate gate, int count)
  {
    RandomStream random(3000);
    for (int trial = 0; trial < count; ++trial)
    {
      const AnonymousScene s = observeAnonymously(random, landmarks, seen, false_count, sigma);
      InterpretationOptions options = optionsFor(sigma, false_count, 1);
      options.gate = gate;
      const std::clock_t begin = std::clock();
      const Interpretations result = interpretBearings(s.scene.landmarks, s.bearings, options);
      microseconds.push_back(1e6 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
      recall += findsTruth(result, s.truth) ? 1. / count : 0;
      solutions += static_cast<double>(result.solutions.size()) / count;
    }
    std::sort(microseconds.begin(), microseconds.end());
  }

  [[nodiscard]] double quantile(double share) const
  {
    return microseconds[static_cast<std::size_t>(share * static_cast<double>(microseconds.size() - 1))];
  }
  [[nodiscard]] double mean() const
  {
    double sum = 0;
    for (const double t : microseconds) sum += t;
    return sum / static_cast<double>(microseconds.size());
  }
};

void recallAndTime(std::ostream& out, int landmarks, int count)
{
  out << "\nRecall of the true assignment and time, " << landmarks << " landmarks, gate 3.3 sigma, " << count
      << " trials each, the area 1 m wider than the square. With a false reading, one bearing may stay unmatched. "
         "Processor "
      << "time:\n\n"
      << "| bearings | false | sigma [deg] | gate | recall | solutions | median [us] | mean [us] | 95 % [us] |\n"
      << "|---|---|---|---|---|---|---|---|---|\n";
  for (const double sigma_deg : {0.05, 0.15, 0.5})
    for (const int seen : {4, 5, 6, 7})
      for (const auto& [false_count, gate] :
           {std::pair(0, InterpretationGate::worst_case), std::pair(0, InterpretationGate::covariance),
            std::pair(1, InterpretationGate::worst_case)})
      {
        if (landmarks > 12 && (seen < 7 || sigma_deg > 0.2 || false_count > 0)) continue;
        const Trials t(landmarks, seen, false_count, degToRad(sigma_deg), gate, count);
        const bool worst = gate == InterpretationGate::worst_case;
        out << std::fixed << "| " << seen << " | " << false_count << " | " << std::setprecision(2) << sigma_deg << " | "
            << (worst ? "worst case" : "covariance") << " | " << std::setprecision(3) << t.recall << " | "
            << std::setprecision(1) << t.solutions << " | " << t.quantile(0.5) << " | " << t.mean() << " | "
            << t.quantile(0.95) << " |\n";
      }
}

void run(std::ostream& out)
{
  equality(out);
  recallAndTime(out, 12, 600);
  recallAndTime(out, 30, 100);
}

const RegisterStudy kStudy("interpretation_tree",
                           "Tens of anonymous landmarks, all in view: is every consistent interpretation found, how "
                           "often the true one, how fast?",
                           run);
}  // namespace
}  // namespace mrpt_ext
