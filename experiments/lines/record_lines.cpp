// SPDX-License-Identifier: MIT
#include "experiments/lines/record_lines.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "experiments/lines/record_fields.hpp"

namespace impetus::inline lines {
namespace {

using nlohmann::json;

/// Lists of lists are not shown: whoever sends them decides how deep they are.
[[noreturn]] void refuse_value(const std::string& expected, const json& got) {
  const bool is_deep =
      got.is_structured() &&
      std::any_of(got.begin(), got.end(), [](const json& each) { return each.is_structured(); });
  const std::string shown =
      is_deep ? std::string("an ") + got.type_name()
              : got.dump(-1, ' ', false, json::error_handler_t::replace).substr(0, 100);
  throw std::runtime_error("expected " + expected + ", got " + shown);
}

/// What a line's "kind" says, in the order of AnyRecord.
constexpr std::array<const char*, std::variant_size_v<AnyRecord>> kKinds{
    "session", "trial", "attempt", "answer", "note", "level", "calibration", "finished"};

template <typename T>
concept Listed = requires(T& value) {
  fields(value, [](const char*, auto&) {});
};

/// Whether a value may be missing.
template <typename T>
struct IsOptional : std::false_type {};
template <typename T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <typename T>
json columns() {
  json names = json::array();
  T record;
  fields(record, [&](const char* name, auto& /*member*/) { names.push_back(name); });
  return names;
}

template <typename T>
json written(const T& value);
template <typename T>
json written(const std::vector<T>& values);

/// The values of a record's fields, without their names.
template <typename T>
json row_of(const T& record) {
  json row = json::array();
  fields(record, [&](const char* /*name*/, const auto& member) { row.push_back(written(member)); });
  return row;
}

template <typename T>
json object_of(const T& record) {
  json object = json::object();
  fields(record, [&](const char* name, const auto& member) { object[name] = written(member); });
  return object;
}

template <typename T>
json written(const std::vector<T>& values) {
  json list = json::array();
  if constexpr (Listed<T>) {
    if (!values.empty()) {
      list.push_back(columns<T>());
    }
    for (const T& value : values) {
      list.push_back(row_of(value));
    }
  } else {
    for (const T& value : values) {
      list.push_back(written(value));
    }
  }
  return list;
}

template <typename T>
json written(const T& value) {
  if constexpr (IsOptional<T>::value) {
    return value ? written(*value) : json();
  } else if constexpr (std::is_enum_v<T>) {
    return Names<T>::kAll[static_cast<std::size_t>(value)];
  } else if constexpr (std::is_same_v<T, LevelValue>) {
    return std::visit([](const auto& one) { return json(one); }, value);
  } else if constexpr (std::is_same_v<T, Vector3>) {
    return {value.x(), value.y(), value.z()};
  } else if constexpr (std::is_same_v<T, WorkGrants>) {
    return value == WorkGrants{} ? json() : json(value.units);
  } else if constexpr (Listed<T>) {
    return row_of(value);
  } else {
    return value;
  }
}

template <typename T>
void read(const json& from, T& value);
template <typename T>
void read(const json& from, std::vector<T>& values);

template <typename T>
void read_row(const json& row, T& record) {
  const json names = columns<T>();
  if (!row.is_array() || row.size() != names.size()) {
    refuse_value("a row of " + names.dump(), row);
  }
  std::size_t column = 0;
  fields(record, [&](const char* /*name*/, auto& member) { read(row[column++], member); });
}

template <typename T>
void read(const json& from, std::vector<T>& values) {
  if (!from.is_array()) {
    refuse_value("a list", from);
  }
  std::size_t first = 0;
  if constexpr (Listed<T>) {
    if (!from.empty() && from[first++] != columns<T>()) {
      refuse_value("the columns " + columns<T>().dump(), from[0]);
    }
  }
  values.clear();
  values.reserve(from.size() - first);
  for (std::size_t i = first; i < from.size(); ++i) {
    T value{};
    if constexpr (Listed<T>) {
      read_row(from[i], value);
    } else {
      read(from[i], value);
    }
    values.push_back(std::move(value));
  }
}

template <typename E>
E named(const json& from) {
  const auto& names = Names<E>::kAll;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (from == names[i]) {
      return static_cast<E>(i);
    }
  }
  refuse_value("one of " + json(names).dump(), from);
}

LevelValue level_from(const json& from) {
  if (from.is_boolean()) {
    return from.get<bool>();
  }
  if (from.is_string()) {
    return from.get<std::string>();
  }
  return from.get<double>();
}

/// A number that its type can hold: nlohmann casts any.
template <std::integral T>
T integer_from(const json& from) {
  const bool holds = from.is_number_unsigned()
                         ? std::in_range<T>(from.get<std::uint64_t>())
                         : from.is_number_integer() && std::in_range<T>(from.get<std::int64_t>());
  if (!holds) {
    refuse_value("an integer from " + std::to_string(std::numeric_limits<T>::min()) + " to " +
                     std::to_string(std::numeric_limits<T>::max()),
                 from);
  }
  return from.get<T>();
}

template <typename T>
void read(const json& from, T& value) {
  if constexpr (IsOptional<T>::value) {
    value.reset();
    if (!from.is_null()) {
      read(from, value.emplace());
    }
  } else if constexpr (std::is_enum_v<T>) {
    value = named<T>(from);
  } else if constexpr (std::is_same_v<T, LevelValue>) {
    value = level_from(from);
  } else if constexpr (std::is_same_v<T, Vector3>) {
    value = {from.at(0).get<double>(), from.at(1).get<double>(), from.at(2).get<double>()};
  } else if constexpr (std::is_same_v<T, WorkGrants>) {
    value = WorkGrants{};
    if (!from.is_null()) {
      std::vector<std::int64_t> units;
      read(from, units);
      if (units.size() != value.units.size()) {
        refuse_value("units of each phase", from);
      }
      std::copy(units.begin(), units.end(), value.units.begin());
    }
  } else if constexpr (Listed<T>) {
    read_row(from, value);
  } else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
    value = integer_from<T>(from);
  } else {
    value = from.get<T>();
  }
}

/// "steps: expected ..." of what was found at a field.
template <typename T>
void read_field(const json& line, const char* name, T& member) {
  try {
    read(line.at(name), member);
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string(name) + ": " + error.what());
  }
}

template <typename T>
AnyRecord read_record(const json& line) {
  T record;
  fields(record, [&](const char* name, auto& member) { read_field(line, name, member); });
  return record;
}

template <std::size_t... kPlaces>
AnyRecord record_of_kind(std::size_t kind, const json& line,
                         std::index_sequence<kPlaces...> /*all*/) {
  using Reader = AnyRecord (*)(const json&);
  constexpr std::array<Reader, sizeof...(kPlaces)> kReaders{
      read_record<std::variant_alternative_t<kPlaces, AnyRecord>>...};
  return kReaders[kind](line);
}

}  // namespace

std::string line_of(const AnyRecord& record, Digests digests) {
  json line = std::visit([](const auto& one) { return object_of(one); }, record);
  line["kind"] = kKinds[record.index()];
  if (digests == Digests::kLeftOut && std::holds_alternative<AttemptRecord>(record)) {
    for (json& row : line["steps"]) {
      json& bodies = row[5];
      bodies = bodies.is_array() ? json::array() : bodies;  // the first row has names
    }
  }
  return line.dump();
}

AnyRecord record_from(const json& line) {
  for (std::size_t kind = 0; line.is_object() && kind < kKinds.size(); ++kind) {
    if (line.contains("kind") && line["kind"] == kKinds[kind]) {
      return record_of_kind(kind, line, std::make_index_sequence<kKinds.size()>());
    }
  }
  refuse_value("a line whose kind is one of " + json(kKinds).dump(), line);
}

}  // namespace impetus::inline lines
