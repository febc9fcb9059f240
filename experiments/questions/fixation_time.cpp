// SPDX-License-Identifier: MIT
#include "experiments/questions/fixation_time.hpp"

#include <string>

#include "engine/numerics/random_stream.hpp"
#include "experiments/record/frame_grid.hpp"

namespace impetus::inline questions {

Kind<FixationTime> fixation_time_kind() {
  const Kind<double> duration = number({0, 60000});
  Form form = list_form(duration, {2, 2});
  form.schema["type"] = {"number", "array"};
  form.schema.update(OrderedJson{{"minimum", 0}, {"maximum", 60000}});
  return {form, [](const nlohmann::json& value) {
            const bool one = value.is_number();
            return FixationTime{(one ? value : value[0]).get<double>(),
                                (one ? value : value[1]).get<double>()};
          }};
}

void check_fixation(const JsonDocument& protocol, const FixationTime& time) {
  if (time.least_ms > time.most_ms) {
    const std::string place = "/timing/fixation_ms";
    refuse(protocol, place,
           "expected the least before the most, got " +
               protocol.value[nlohmann::json::json_pointer(place)].dump());
  }
}

std::int64_t fixation_frames(const FixationTime& time, std::uint64_t seed, std::int64_t interval,
                             double refresh_hz) {
  const std::int64_t least = whole_frames(time.least_ms / 1e3, refresh_hz);
  const std::int64_t most = whole_frames(time.most_ms / 1e3, refresh_hz);
  if (most <= least) {
    return least;
  }
  RandomStream stream(seed, "fixation/" + std::to_string(interval));
  return least +
         static_cast<std::int64_t>(stream.below(static_cast<std::uint64_t>(most - least + 1)));
}

}  // namespace impetus::inline questions
