#include "mrpt_ext/app/shell_quote.h"

namespace mrpt_ext
{
namespace
{
constexpr const char* kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_@%+=:,./-";

std::string shellWord(const std::string& word)
{
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word)
    if (c == '\'')
      quoted += "'\\''";  // ends the quotes, a quote by itself, begins them again
    else
      quoted += c;
  return quoted + "'";
}
}  // namespace

std::string shellLine(const std::vector<std::string>& words)
{
  std::string line;
  for (const std::string& word : words)
  {
    if (!line.empty()) line += ' ';
    line += shellWord(word);
  }
  return line;
}
}  // namespace mrpt_ext
