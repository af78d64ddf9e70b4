#include <iostream>

#include "mrpt_ext/files/atomic_file.h"
#include "paper_settings.h"
#include "sections.h"

namespace mrpt_ext::papers
{
namespace
{
constexpr const char* kIntroduction =
    "# The papers, reproduced\n\n"
    "Written by `cmake --build build --target papers`; run again on the same machine it gives the same bytes. Every "
    "figure below comes from that command, except those in the column *paper*, which are quoted from print.\n\n"
    "Three papers on localization by landmarks are implemented in this project: *000*, a pose from bearings to "
    "landmarks that nobody names; *001*, MOVIS, three omnidirectional cameras that look at two poles; *004*, running "
    "fixes by narrow stereo on a MiroSot field. This page repeats their tables in simulation. Each row has the "
    "printed figure, what the *same closed form* gives in our simulation, what *our best estimator* makes of the same "
    "measurements, and the *limit*: what no unbiased estimator can beat (Cramer-Rao), as an error drawn from it where "
    "means of distances are compared. ± is a standard deviation unless the text says otherwise. The outcome is one of "
    "*reproduced*, *differs because ...*, and *not reproducible, input missing*: the papers leave out much of what "
    "their experiments depend on. Scenarios are .ini files; the same code runs on fewer trials in "
    "`build/bin/test_papers`.\n\n";

std::string results()
{
  const auto note = [](const char* what) { std::cerr << "papers: " << what << std::endl; };
  std::string text = kIntroduction;
  const auto add = [&](const ResultSection& section) { text += markdown(section) + "\n"; };
  note("000, interpretation tree");
  add(sectionTree(runTreeExperiment(paperSettings("paper-000-table-1"))));
  note("001, lattice, cameras, drive");
  const Settings lattice = paperSettings("paper-001-lattice");
  for (const ResultSection& section :
       sectionsMovis(runMovisExperiment(lattice), scanYaw(lattice), runDrives(paperSettings("paper-001-drive")),
                     runDrives(paperSettings("paper-001-drive-turned"))))
    add(section);
  for (const ResultSection& section : sectionsRebuilt(readLattice(lattice))) add(section);
  note("004, ranges, running fixes, drive");
  const Settings ranges = paperSettings("paper-004-ranges");
  add(sectionRanges(runRangeExperiment(ranges), tryOtherPlaces(ranges)));
  for (const ResultSection& section : sectionsLocated(runLocatedExperiment(paperSettings("paper-004-located")),
                                                      runDrives(paperSettings("paper-004-drive"))))
    add(section);
  note("004, what it leaves open");
  add(sectionFixStudy(runFixStudy(paperSettings("paper-004-open-study"))));
  add(sectionErrata());
  text.pop_back();
  return text;
}
}  // namespace
}  // namespace mrpt_ext::papers

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "usage: paper_results RESULTS.md\n";
    return 2;
  }
  try
  {
    mrpt_ext::writeFileAtomically(argv[1], mrpt_ext::papers::results());
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
