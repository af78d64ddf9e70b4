#include "mrpt_ext/settings/setting_value.h"

#include <cctype>
#include <charconv>

#include "mrpt_ext/files/number_format.h"

namespace mrpt_ext
{
std::optional<std::int64_t> parseWholeNumber(const std::string& text)
{
  const char* first = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* last = text.data() + text.size();
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc{} || end != last || first == last) return std::nullopt;
  return value;
}

std::optional<bool> parseFlag(const std::string& text)
{
  std::string word;
  for (const char c : text) word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (word == "true" || word == "yes" || word == "on" || word == "1") return true;
  if (word == "false" || word == "no" || word == "off" || word == "0") return false;
  return std::nullopt;
}

std::vector<std::string> parseWords(const std::string& text)
{
  std::vector<std::string> words;
  constexpr const char* kSeparators = " \t,";
  for (std::size_t begin = text.find_first_not_of(kSeparators); begin != std::string::npos;)
  {
    const std::size_t end = text.find_first_of(kSeparators, begin);
    words.push_back(text.substr(begin, end == std::string::npos ? end : end - begin));
    begin = end == std::string::npos ? end : text.find_first_not_of(kSeparators, end);
  }
  return words;
}

std::optional<std::vector<double>> parseNumbers(const std::string& text)
{
  std::vector<double> numbers;
  for (const std::string& word : parseWords(text))
  {
    const auto number = parseNumber(word);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  if (numbers.empty()) return std::nullopt;
  return numbers;
}

std::optional<std::string> parseChoice(const std::string& text, const std::vector<KeyChoice>& choices)
{
  const auto number = parseWholeNumber(text);
  for (const KeyChoice& choice : choices)
    if (choice.name == text || (number && choice.number && *number == *choice.number)) return choice.name;
  return std::nullopt;
}
}  // namespace mrpt_ext
