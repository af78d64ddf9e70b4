#include <cstddef>
#include <cstdint>

#include "fuzz_targets.h"

// libFuzzer's entry; the target is chosen when it is built.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const mrpt_ext::FuzzTarget kTarget = mrpt_ext::fuzzTargets().at(MRPT_EXT_FUZZ_TARGET);
  kTarget({reinterpret_cast<const char*>(data), size});
  return 0;
}
