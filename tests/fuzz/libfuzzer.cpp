// The entry that libFuzzer calls; IMPETUS_FUZZ_TARGET is one of targets.hpp. Where that reads JSON
// (IMPETUS_FUZZ_JSON), every other input has a value changed instead of bytes.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "tests/fuzz/json_mutation.hpp"
#include "tests/fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  impetus::IMPETUS_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}

#ifdef IMPETUS_FUZZ_JSON
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed) {
  if (seed % 4 == 0) {
    return LLVMFuzzerMutate(data, size, most);
  }
  impetus::RandomStream random(seed, "mutation");
  const std::string changed =
      impetus::mutated_pair({reinterpret_cast<const char*>(data), size}, random);
  const std::size_t length = std::min(changed.size(), most);
  std::memcpy(data, changed.data(), length);
  return length;
}
#endif
