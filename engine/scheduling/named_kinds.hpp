// The table of a kind's members by their names, for kinds that need nothing beside it: one object
// of each, which all who name it share.
// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace impetus::inline scheduling {

/// The names with commas between them.
inline std::string list_names(const std::vector<std::string_view>& names) {
  std::string list;
  for (const std::string_view name : names) {
    list += (list.empty() ? "" : ", ") + std::string(name);
  }
  return list;
}

template <typename Kind>
/// The shared objects of one kind of thing, such as traversals, by their names.
class NamedKinds {
 public:
  /// One of them.
  struct Row {
    std::string_view name;
    std::shared_ptr<const Kind> kind;
    std::string_view words{};  ///< what it is
  };

  /// `what` begins the sentence that refuses a name.
  NamedKinds(std::string_view what, std::initializer_list<Row> rows) : what_(what), rows_(rows) {}

  /// Throws std::invalid_argument that lists the names there are.
  [[nodiscard]] const std::shared_ptr<const Kind>& called(std::string_view name) const {
    for (const Row& row : rows_) {
      if (row.name == name) {
        return row.kind;
      }
    }
    throw std::invalid_argument(what_ + ": expected one of " + list_names(names()) + ", got \"" +
                                std::string(name) + "\"");
  }

  /// Empty when `kind` is none of the table's own.
  [[nodiscard]] std::string_view name(const Kind& kind) const {
    for (const Row& row : rows_) {
      if (row.kind.get() == &kind) {
        return row.name;
      }
    }
    return "";
  }

  [[nodiscard]] std::vector<std::string_view> names() const {
    std::vector<std::string_view> names;
    for (const Row& row : rows_) {
      names.push_back(row.name);
    }
    return names;
  }

  /// "depth-first: one pair after the other. ..."
  [[nodiscard]] std::string in_words() const {
    std::string words;
    for (const Row& row : rows_) {
      words += words.empty() ? "" : " ";
      words += std::string(row.name) + ": " + std::string(row.words) + ".";
    }
    return words;
  }

 private:
  std::string what_;
  std::vector<Row> rows_;
};

}  // namespace impetus::inline scheduling
