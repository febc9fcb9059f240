// The shipped study with single values changed, and the sentence with which it is refused.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "experiments/protocol/protocol_file.hpp"
#include "tests/experiments/temporary_folder.hpp"
#include "tests/places/places.hpp"

namespace impetus {

using nlohmann::json;

inline constexpr const char* kProtocolName = "protocols/causality.json";
inline constexpr const char* kSceneName = "stimuli/two-spheres.json";

inline std::string shipped(const std::string& path) {
  return text_of(std::filesystem::path(source_folder()) / path);
}

/// The sentence with which something is refused; "accepted" when it is not.
inline std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

inline std::string json_refusal(const std::string& text) {
  return refusal([&] { parse_json("a.json", text); });
}

inline void erase(json& object, const std::string& pointer) {
  const json::json_pointer place(pointer);
  object[place.parent_pointer()].erase(place.back());
}

/// The shipped protocol and its scene, with single values changed.
class Study {
 public:
  Study& with(const std::string& pointer, json value) {
    protocol_[json::json_pointer(pointer)] = std::move(value);
    return *this;
  }
  Study& without(const std::string& pointer) {
    erase(protocol_, pointer);
    return *this;
  }
  Study& scene_with(const std::string& pointer, json value) {
    scene_[json::json_pointer(pointer)] = std::move(value);
    return *this;
  }
  Study& scene_without(const std::string& pointer) {
    erase(scene_, pointer);
    return *this;
  }

  [[nodiscard]] Protocol made() const {
    return make_protocol(parse_json(kProtocolName, protocol_.dump()),
                         parse_json(kSceneName, scene_.dump()));
  }
  [[nodiscard]] std::string refused() const {
    return refusal([this] { static_cast<void>(made()); });
  }

 private:
  json protocol_ = json::parse(shipped(kProtocolName));
  json scene_ = json::parse(shipped(kSceneName));
};

/// One changed value and the sentence that it deserves, after the file's name.
struct Case {
  std::string pointer;
  json value;
  std::string sentence;
};

inline void expect_protocol_refusals(const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    EXPECT_EQ(Study().with(one.pointer, one.value).refused(),
              std::string(kProtocolName) + ":" + one.sentence);
  }
}

inline void expect_scene_refusals(const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    EXPECT_EQ(Study().scene_with(one.pointer, one.value).refused(),
              std::string(kSceneName) + ":" + one.sentence);
  }
}

}  // namespace impetus
