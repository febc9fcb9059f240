// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "experiments/models/tree_file.hpp"
#include "tests/fuzz/targets.hpp"

namespace impetus {

void fuzz_tree_file(std::string_view bytes) {
  const std::string file = sealed(std::string(bytes));
  try {
    const StoredTree stored = stored_tree_from(file, "a.tree");
    const std::string again = bytes_of(stored);
    if (bytes_of(stored_tree_from(again, "a.tree")) != again) {
      std::abort();  // what is accepted is read back the same
    }
    for (int level = 0; level < stored.tree.level_count(); ++level) {
      for (const std::int32_t node : stored.tree.standing_at(level)) {
        bounding_sphere(stored.tree.volume(node));
      }
    }
  } catch (const std::runtime_error& error) {
    if (std::string(error.what()).find("a.tree: ") != 0) {
      std::abort();  // a refusal names the file
    }
  }
}

}  // namespace impetus
