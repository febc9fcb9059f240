// SPDX-License-Identifier: MIT
#include "experiments/site/session_keeping.hpp"
#include "tests/fuzz/refusals.hpp"
#include "tests/fuzz/small_studies.hpp"
#include "tests/fuzz/targets.hpp"

namespace impetus {

void fuzz_lines(std::string_view bytes) {
  static const PublishedStudy published = small_published_study();
  static const Protocol protocol = protocol_of(published, std::make_shared<ShapeLibrary>());
  SessionProof proof(kFuzzedSession, published, protocol,
                     [](const SessionRecord& /*session*/) { return std::nullopt; });
  expect_taken_or_refused({kFuzzedSession}, [&] {
    for (const std::string& line : lines_in(std::string(bytes))) {
      proof.take(line);
    }
  });
}

}  // namespace impetus
