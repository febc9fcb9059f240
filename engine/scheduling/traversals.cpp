// SPDX-License-Identifier: MIT
#include "engine/scheduling/traversals.hpp"

#include "engine/scheduling/gain_traversals.hpp"
#include "engine/scheduling/level_traversals.hpp"
#include "engine/scheduling/named_kinds.hpp"

namespace impetus::inline scheduling {
namespace {

const NamedKinds<Traversal>& all_traversals() {
  static const NamedKinds<Traversal> all(
      "traversal", {{"depth-first", std::make_shared<const DepthFirst>()},
                    {"breadth-first", std::make_shared<const BreadthFirst>()},
                    {"best-first", std::make_shared<const BestFirst>()},
                    {"visible-first", std::make_shared<const VisibleFirst>()}});
  return all;
}

}  // namespace

std::shared_ptr<const Traversal> make_traversal(std::string_view name) {
  return all_traversals().called(name);
}

std::string_view traversal_name(const Traversal& traversal) {
  return all_traversals().name(traversal);
}

std::vector<std::string_view> traversal_names() { return all_traversals().names(); }

}  // namespace impetus::inline scheduling
