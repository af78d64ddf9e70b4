#include "mrpt_ext/front_ends/jpeg_integrity.h"

#include <csetjmp>
#include <cstdio>  // jpeglib.h needs it before

#include <jpeglib.h>

#include <vector>

namespace mrpt_ext
{
namespace
{
constexpr int kMostScans = 100;  // of a progressive file; each costs a pass over all pixels

/// libjpeg leaves an error through longjmp; warnings are counted and not written.
struct SilentDecoder
{
  jpeg_decompress_struct state{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf leave{};

  SilentDecoder()
  {
    state.err = jpeg_std_error(&errors);
    state.client_data = this;
    errors.error_exit = [](j_common_ptr decoder) { std::longjmp(of(decoder).leave, 1); };
    errors.output_message = [](j_common_ptr) {};
    jpeg_create_decompress(&state);
    progress.progress_monitor = [](j_common_ptr decoder)
    {
      SilentDecoder& self = of(decoder);
      if (self.state.input_scan_number > kMostScans) std::longjmp(self.leave, 1);
    };
    state.progress = &progress;
  }
  ~SilentDecoder() { jpeg_destroy_decompress(&state); }
  SilentDecoder(const SilentDecoder&) = delete;
  SilentDecoder& operator=(const SilentDecoder&) = delete;

  static SilentDecoder& of(j_common_ptr decoder) { return *static_cast<SilentDecoder*>(decoder->client_data); }
};

// Nothing with a destructor lives in these two: longjmp() would pass over it.
bool readHeader(SilentDecoder& decoder, std::string_view bytes)
{
  if (setjmp(decoder.leave) != 0) return false;
  jpeg_mem_src(&decoder.state, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  return jpeg_read_header(&decoder.state, TRUE) == JPEG_HEADER_OK;
}

bool readRows(SilentDecoder& decoder, std::vector<unsigned char>& row)
{
  if (setjmp(decoder.leave) != 0) return false;
  decoder.state.out_color_space = decoder.state.jpeg_color_space;
  decoder.state.do_fancy_upsampling = FALSE;
  jpeg_start_decompress(&decoder.state);
  row.resize(std::size_t{decoder.state.output_width} * static_cast<std::size_t>(decoder.state.output_components));
  while (decoder.state.output_scanline < decoder.state.output_height)
  {
    unsigned char* into = row.data();
    jpeg_read_scanlines(&decoder.state, &into, 1);
  }
  return jpeg_finish_decompress(&decoder.state) == TRUE;
}
}  // namespace

std::optional<std::pair<double, double>> jpegSize(std::string_view bytes)
{
  SilentDecoder decoder;
  if (!readHeader(decoder, bytes)) return std::nullopt;
  return std::pair<double, double>(decoder.state.image_width, decoder.state.image_height);
}

bool isWholeJpeg(std::string_view bytes)
{
  SilentDecoder decoder;
  std::vector<unsigned char> row;
  return readHeader(decoder, bytes) && readRows(decoder, row) && decoder.errors.num_warnings == 0;
}
}  // namespace mrpt_ext
