// The entry that libFuzzer calls; IMPETUS_FUZZ_TARGET is one of targets.hpp.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  impetus::IMPETUS_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
