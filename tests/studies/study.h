#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace mrpt_ext
{
/// A measured claim: runs many trials and prints a table (Markdown). `build/bin/studies` lists them,
/// `build/bin/studies NAME...` runs them at their full size.
struct Study
{
  std::string name;
  std::string question;  ///< what it measures, one line
  std::function<void(std::ostream&)> run;
};

inline std::vector<Study>& allStudies()
{
  static std::vector<Study> studies;
  return studies;
}

/// Put one at namespace scope in the study's file.
struct RegisterStudy
{
  RegisterStudy(std::string name, std::string question, std::function<void(std::ostream&)> run)
  {
    allStudies().push_back({std::move(name), std::move(question), std::move(run)});
  }
};
}  // namespace mrpt_ext
