#include "mrpt_ext/importers/rosbag2/block_decompression.h"

#include <lz4frame.h>

#include <fstream>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "mrpt_ext/files/decompressor.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/rosbag2/byte_reader.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kPiece = 1 << 17;  // [bytes]

using PieceSink = std::function<void(std::string_view)>;

/// Passes on what comes out of the next `bytes`.
void decompress(Decompressor& stream, std::string_view bytes, const PieceSink& sink)
{
  std::span in(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  std::vector<unsigned char> piece(kPiece);
  for (std::size_t count = piece.size(); !in.empty() || count == piece.size();)
  {
    count = stream.decompress(in, piece);
    if (!stream.damage().empty()) throw DamagedBytes(stream.damage());
    sink({reinterpret_cast<const char*>(piece.data()), count});
  }
}

void expectComplete(const Decompressor& stream)
{
  if (!stream.complete()) throw DamagedBytes("the compressed data is cut off");
}

void decompressLz4(std::string_view block, const PieceSink& sink)
{
  LZ4F_dctx* created = nullptr;
  LZ4F_createDecompressionContext(&created, LZ4F_VERSION);
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(created,
                                                                                     &LZ4F_freeDecompressionContext);
  std::vector<char> piece(kPiece);
  std::size_t missing = 1;
  bool full = false;
  while (!block.empty() || full)
  {
    std::size_t in = block.size(), out = piece.size();
    missing = LZ4F_decompress(context.get(), piece.data(), &out, block.data(), &in, nullptr);
    if (LZ4F_isError(missing))
      throw DamagedBytes(std::string("the compressed data is damaged (") + LZ4F_getErrorName(missing) + ")");
    sink({piece.data(), out});
    block.remove_prefix(in);
    full = out == piece.size();
    if (in == 0 && out == 0) break;
  }
  if (missing != 0) throw DamagedBytes("the compressed data is cut off");
}
}  // namespace

std::string decompressedBlock(std::string_view block, std::string_view method, std::uint64_t limit)
{
  std::string content;
  const auto append = [&](std::string_view piece)
  {
    if (piece.size() > limit - content.size())
      throw DamagedBytes("it unpacks to more than " + std::to_string(limit) + " bytes");
    content.append(piece);
  };
  if (method.empty())
    append(block);
  else if (method == "lz4")
    decompressLz4(block, append);
  else if (method == "zstd")
  {
    const auto stream = makeDecompressor(Compression::zstd);
    decompress(*stream, block, append);
    expectComplete(*stream);
  }
  else
    throw DamagedBytes("compressed by '" + std::string(method) + "', expected lz4, zstd or nothing");
  return content;
}

void decompressZstdFile(const std::filesystem::path& from, const std::filesystem::path& to)
{
  std::ifstream in(from, std::ios::binary);
  std::ofstream out(to, std::ios::binary);
  if (!in || !out) throw dataError((in ? to : from).string() + ": cannot be opened");
  const auto stream = makeDecompressor(Compression::zstd);
  std::vector<char> bytes(kPiece);
  try
  {
    while (in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())), in.gcount() > 0)
      decompress(*stream, {bytes.data(), static_cast<std::size_t>(in.gcount())},
                 [&](std::string_view piece) { out.write(piece.data(), static_cast<std::streamsize>(piece.size())); });
    expectComplete(*stream);
  }
  catch (const DamagedBytes& damage)
  {
    throw dataError(from.string() + ": " + damage.what());
  }
  if (!out.flush()) throw dataError(to.string() + ": cannot be written (is the disk full?)");
}
}  // namespace mrpt_ext
