#include "errata.h"

#include <algorithm>
#include <cctype>

namespace mrpt_ext::papers
{
std::vector<Erratum> allErrata()
{
  std::vector<Erratum> all;
  for (auto& errata : {errataOfPaper000(), errataOfPaper001(), errataOfPaper004()})
    all.insert(all.end(), errata.begin(), errata.end());
  return all;
}

std::string testName(const Erratum& erratum)
{
  std::string name = "Paper" + erratum.where;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  name.erase(std::unique(name.begin(), name.end(), [](char a, char b) { return a == '_' && b == '_'; }), name.end());
  return name;
}
}  // namespace mrpt_ext::papers
