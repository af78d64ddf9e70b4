#include <algorithm>
#include <iostream>

#include "study.h"

int main(int argc, char** argv)
{
  using namespace mrpt_ext;
  std::vector<Study>& studies = allStudies();
  std::sort(studies.begin(), studies.end(), [](const Study& a, const Study& b) { return a.name < b.name; });
  if (argc < 2)
  {
    for (const Study& study : studies) std::cout << study.name << ": " << study.question << '\n';
    return 0;
  }
  for (int i = 1; i < argc; ++i)
  {
    const auto study = std::find_if(studies.begin(), studies.end(), [&](const Study& s) { return s.name == argv[i]; });
    if (study == studies.end())
    {
      std::cerr << "studies: no study named '" << argv[i] << "'; without an argument they are listed\n";
      return 2;
    }
    std::cout << "## " << study->name << "\n\n" << study->question << "\n\n";
    study->run(std::cout);
    std::cout << std::endl;
  }
  return 0;
}
