// A simulated study of a power analysis once it is tested: its rows in the ledger and in chunks.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace impetus::inline power {

/// The test of one factor.
struct StudyTest {
  std::string factor;
  std::optional<double> p;  ///< none: no test could be made, and the remark says why
  std::string method;
  std::string remark;
};

/// So many participants of one simulation, and what their tests found.
struct TestedStudy {
  bool effect{true};
  std::int64_t number{1};
  std::int64_t participants{2};
  std::int64_t seed{1};
  std::string build;        ///< that simulated it
  double simulated_s{0.0};  ///< what it took, of all its participants
  std::vector<StudyTest> tests;
};

}  // namespace impetus::inline power
