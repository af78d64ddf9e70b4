#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // of OpenSSL

namespace mrpt_ext
{
/// SHA-256 of bytes that come piece by piece.
class Sha256
{
 public:
  Sha256();
  void add(std::span<const unsigned char> bytes);
  /// Lower-case hexadecimal; ends the digest.
  [[nodiscard]] std::string hex();

 private:
  std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

[[nodiscard]] std::string sha256OfText(std::string_view text);

/// Of a whole file; empty when it cannot be read.
[[nodiscard]] std::string sha256OfFile(const std::filesystem::path& path);
}  // namespace mrpt_ext
