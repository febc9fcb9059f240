// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/design_words.hpp"
#include "experiments/protocol/protocol_file.hpp"
#include "tests/fuzz/asked_work.hpp"
#include "tests/fuzz/refusals.hpp"
#include "tests/fuzz/targets.hpp"

namespace impetus {

void fuzz_protocol(std::string_view bytes) {
  const std::size_t end = std::min(bytes.find(kPartSeparator), bytes.size());
  expect_taken_or_refused({"protocol.json:", "scene.json:"}, [&] {
    JsonDocument document = parse_json("protocol.json", std::string(bytes.substr(0, end)));
    JsonDocument scene =
        parse_json("scene.json", std::string(bytes.substr(std::min(end + 1, bytes.size()))));
    if (asks_for_much(scene.value, document.value)) {
      return;
    }
    const Protocol protocol = make_protocol(std::move(document), std::move(scene));
    check_frames(protocol, /*refresh_hz=*/60.0, /*allow_rounding=*/false);
    plan_for(protocol, "P01", /*seed=*/1);
    design_lines(protocol.design);
  });
}

}  // namespace impetus
