// What is wrong with a scene beyond its schema, in the order in which it is found.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace impetus::inline scenes {

/// A broken rule with its JSON Pointer.
struct SceneProblem {
  std::string pointer;
  std::string message;  ///< "expected ..., got ..."
};

/// Collects them; rules are asked of structs, and words quote what is written.
class SceneProblems {
 public:
  /// `written` must outlive this.
  explicit SceneProblems(const nlohmann::json& written) : written_(&written) {}

  void add(std::string pointer, std::string message) {
    list_.push_back({std::move(pointer), std::move(message)});
  }

  /// The same and what is written there: "expected ..., got 3".
  void add_got(const std::string& pointer, const std::string& message) {
    add(pointer, message + ", got " + written(pointer));
  }

  /// Of an object at `pointer` that lacks a key, which it needs `why`: "for kind fixed".
  void add_missing(const std::string& pointer, const std::string& key, const std::string& why) {
    add(pointer,
        "expected the key \"" + key + "\"" + (why.empty() ? "" : " " + why) + ", which is missing");
  }

  /// Whether anything is written there.
  [[nodiscard]] bool says(const std::string& pointer) const {
    return written_->contains(nlohmann::json::json_pointer(pointer));
  }

  /// What is written there, as JSON. Precondition: something is.
  [[nodiscard]] std::string written(const std::string& pointer) const {
    return written_->at(nlohmann::json::json_pointer(pointer)).dump();
  }

  /// The same, or the default where nothing is.
  [[nodiscard]] std::string written_or(const std::string& pointer, double otherwise) const {
    return says(pointer) ? written(pointer) : nlohmann::json(otherwise).dump();
  }

  /// What the builders of trees say, "tree: expected ...", of the kind at `pointer`; "": nothing.
  void add_tree_problem(const std::string& pointer, const std::string& problem) {
    const std::string prefix = "tree: ";
    if (!problem.empty()) {
      add(pointer, problem.starts_with(prefix) ? problem.substr(prefix.size()) : problem);
    }
  }

  [[nodiscard]] bool empty() const { return list_.empty(); }
  [[nodiscard]] std::size_t size() const { return list_.size(); }
  [[nodiscard]] const std::vector<SceneProblem>& list() const { return list_; }

 private:
  const nlohmann::json* written_;
  std::vector<SceneProblem> list_;
};

}  // namespace impetus::inline scenes
