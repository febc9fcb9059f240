// What the command line of a benchmark of crowds asks for.
//
//   PROGRAM [--only SCENE] [--steps N] [--quick] [MESH]
//
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace impetus {

struct BenchOptions {
  std::optional<std::string> mesh;
  std::optional<std::string> only;  ///< scenes whose name begins so
  std::optional<int> steps;         ///< in place of the scenes' own numbers
  bool quick{false};                ///< a tenth of the steps and poses

  [[nodiscard]] bool asks_for(const std::string& scene) const;
  /// The scene's own number, or what was asked for.
  [[nodiscard]] int steps_of(int own) const;
  /// The scene's own number of poses or repetitions, or a tenth.
  [[nodiscard]] int count_of(int own) const;
};

/// Throws std::invalid_argument, in one sentence.
BenchOptions bench_options(int count, char** arguments);

}  // namespace impetus
