// SPDX-License-Identifier: MIT
#include "tests/bench/bench_options.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace impetus {
namespace {

int positive_number(const std::string& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 1) {
    throw std::invalid_argument("--steps: expected a whole number of at least 1, got \"" + text +
                                "\"");
  }
  return number;
}

}  // namespace

bool BenchOptions::asks_for(const std::string& scene) const {
  return !only || scene.rfind(*only, 0) == 0;
}

int BenchOptions::steps_of(int own) const { return steps ? *steps : count_of(own); }

int BenchOptions::count_of(int own) const { return quick ? std::max(1, own / 10) : own; }

BenchOptions bench_options(int count, char** arguments) {
  BenchOptions options;
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    const auto value = [&] {
      if (++i >= count) {
        throw std::invalid_argument(argument + ": expected a value after it, got nothing");
      }
      return std::string(arguments[i]);
    };
    if (argument == "--only") {
      options.only = value();
    } else if (argument == "--steps") {
      options.steps = positive_number(value());
    } else if (argument == "--quick") {
      options.quick = true;
    } else if (argument.rfind("--", 0) == 0) {
      throw std::invalid_argument("expected --only SCENE, --steps N, --quick or a mesh file, got " +
                                  argument);
    } else {
      options.mesh = argument;
    }
  }
  return options;
}

}  // namespace impetus
