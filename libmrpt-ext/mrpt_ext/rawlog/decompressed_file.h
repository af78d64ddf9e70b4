#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mrpt_ext/files/decompressor.h"
#include "mrpt_ext/rawlog/sha256.h"

namespace mrpt_ext
{
/// The content of a file that is compressed with gzip, with zstd, or not at all.
class DecompressedFile
{
 public:
  /// Throws InputError (data) when the file is missing, a folder, not readable or empty. With a `digest`, all bytes of
  /// the file are added to it while they are read.
  explicit DecompressedFile(const std::filesystem::path& path, Sha256* digest = nullptr);

  /// Fills `out` from its front; less than all of it only at the end of the content, or where it is damaged.
  std::size_t read(std::span<unsigned char> out);
  /// Reads what is left of the file without decompressing it, for the digest.
  void readRest();

  [[nodiscard]] Compression compression() const { return compression_; }
  /// What is wrong with the compression; final once read() has come to the end.
  [[nodiscard]] std::string damage() const;

 private:
  void readBytes();

  std::filesystem::path path_;
  Sha256* digest_;
  std::ifstream file_;
  std::vector<unsigned char> buffer_;
  std::span<const unsigned char> bytes_;  ///< of the buffer, not yet decompressed
  bool ended_ = false;                    ///< the file has no more bytes
  Compression compression_ = Compression::none;
  std::unique_ptr<Decompressor> decompressor_;
};
}  // namespace mrpt_ext
