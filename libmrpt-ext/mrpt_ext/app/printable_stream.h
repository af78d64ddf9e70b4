#pragma once

#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

namespace mrpt_ext
{
/// `text` with everything that could act on a terminal written out as \xNN: control characters other than line ends and
/// tabs, and bytes that are not UTF-8. Names and labels of an input file may hold any byte.
[[nodiscard]] std::string printable(std::string_view text);

/// Passes lines on to another stream, printable. Fails where that stream fails: ask good() after flush(), then error().
class PrintableStream : public std::ostream
{
 public:
  explicit PrintableStream(std::ostream& target) : std::ostream(nullptr), buffer_(target) { rdbuf(&buffer_); }
  ~PrintableStream() override { flush(); }

  /// The errno of the first failure, 0 when it left none.
  [[nodiscard]] int error() const { return buffer_.error(); }

 private:
  class LineBuffer : public std::streambuf
  {
   public:
    explicit LineBuffer(std::ostream& target) : target_(target) {}
    [[nodiscard]] int error() const { return error_; }

   protected:
    int overflow(int character) override;
    int sync() override;

   private:
    [[nodiscard]] bool passOn(bool flushed);

    std::ostream& target_;
    std::string line_;
    int error_ = 0;
  };

  LineBuffer buffer_;
};
}  // namespace mrpt_ext
