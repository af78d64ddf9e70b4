#include "mrpt_ext/importers/rosbag2/block_decompression.h"

#include <lz4frame.h>
#include <zstd.h>

#include <fstream>
#include <functional>
#include <memory>
#include <vector>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/rosbag2/byte_reader.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kPiece = 1 << 17;  // [bytes]

using PieceSink = std::function<void(std::string_view)>;

class ZstdStream
{
 public:
  /// Passes on what comes out of `bytes`.
  void decompress(std::string_view bytes, const PieceSink& sink)
  {
    ZSTD_inBuffer input{bytes.data(), bytes.size(), 0};
    bool full = false;
    while (input.pos < input.size || full)
    {
      ZSTD_outBuffer output{piece_.data(), piece_.size(), 0};
      missing_ = ZSTD_decompressStream(stream_.get(), &output, &input);
      if (ZSTD_isError(missing_))
        throw DamagedBytes(std::string("damaged zstd data (") + ZSTD_getErrorName(missing_) + ")");
      sink({piece_.data(), output.pos});
      full = output.pos == output.size;
    }
  }
  [[nodiscard]] bool complete() const { return missing_ == 0; }

 private:
  std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream_{ZSTD_createDStream(), &ZSTD_freeDStream};
  std::vector<char> piece_ = std::vector<char>(kPiece);
  std::size_t missing_ = 1;
};

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
    if (LZ4F_isError(missing)) throw DamagedBytes(std::string("damaged lz4 data (") + LZ4F_getErrorName(missing) + ")");
    sink({piece.data(), out});
    block.remove_prefix(in);
    full = out == piece.size();
    if (in == 0 && out == 0) break;
  }
  if (missing != 0) throw DamagedBytes("the lz4 data is cut off");
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
    ZstdStream stream;
    stream.decompress(block, append);
    if (!stream.complete()) throw DamagedBytes("the zstd data is cut off");
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
  ZstdStream stream;
  std::vector<char> bytes(kPiece);
  try
  {
    while (in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())), in.gcount() > 0)
      stream.decompress({bytes.data(), static_cast<std::size_t>(in.gcount())}, [&](std::string_view piece)
                        { out.write(piece.data(), static_cast<std::streamsize>(piece.size())); });
    if (!stream.complete()) throw DamagedBytes("the zstd data is cut off");
  }
  catch (const DamagedBytes& damage)
  {
    throw dataError(from.string() + ": " + damage.what());
  }
  if (!out.flush()) throw dataError(to.string() + ": cannot be written (is the disk full?)");
}
}  // namespace mrpt_ext
