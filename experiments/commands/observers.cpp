// `impetus observers`: the simulated participants that there are, or one of them whole.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/shipped_file.hpp"
#include "experiments/protocol/observer_file.hpp"
#include "experiments/tables/text_table.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kFolder = "experiments/observers";
constexpr const char* kSchema = "observer.schema.json";

/// The names of the files that come with the program, in order.
std::vector<std::string> shipped_names() {
  const fs::path schema = shipped_file(std::string(kFolder) + "/" + kSchema);
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(schema.parent_path(), ignored)) {
    if (entry.path().extension() == ".json" && entry.path().filename() != kSchema) {
      names.push_back(entry.path().stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// A participant's file, by its path or the name of one that comes with the program.
ObserverFile named_observer(const std::string& name) {
  const fs::path shipped = shipped_file(std::string(kFolder) + "/" + name + ".json");
  return load_observer(fs::exists(shipped) ? shipped.string() : name, ".");
}

int list_observers() {
  std::vector<std::vector<std::string>> rows{{"participant", "kind", "looks at"}};
  for (const std::string& name : shipped_names()) {
    const ObserverFile file = named_observer(name);
    rows.push_back({name, file.kind->name, attention_of(file).words});
  }
  std::printf("%s\n", text_table(rows).c_str());
  rows = {{"kind", "what it does"}};
  for (const ObserverKind& kind : observer_kinds()) {
    rows.push_back({kind.name, kind.words});
  }
  std::printf(
      "%s\n`impetus observers NAME` explains a participant or a kind whole; %s/%s is the "
      "schema of their files.\n",
      text_table(rows).c_str(), kFolder, kSchema);
  return kDone;
}

/// "from 0 to 1", "at least 0.001", "any number"
std::string range_words(const ParameterEntry& entry) {
  const auto text = [](double number) { return to_text(LevelValue{number}); };
  const bool has_most = entry.maximum < kAny;
  if (entry.minimum <= -kAny) {
    return has_most ? "at most " + text(entry.maximum) : "any number";
  }
  return has_most ? text(entry.minimum) + " to " + text(entry.maximum)
                  : "at least " + text(entry.minimum);
}

/// A kind's parameters; with the values of `own`, unless null.
void print_parameters(const ObserverKind& kind, const json* own) {
  std::vector<std::vector<std::string>> rows{{"parameter", own ? "value" : "may be", "meaning"}};
  for (const ParameterEntry& entry : kind.parameters) {
    std::string value = range_words(entry) + (entry.optional ? ", or left out" : "");
    if (own != nullptr) {
      const auto found = own->find(entry.name);
      value = found == own->end() ? "left out"
                                  : (*found)["value"].dump() + " " + (*found).value("unit", "");
    }
    rows.push_back({entry.name, value, entry.words});
  }
  if (!kind.has_own_scale) {
    rows.push_back({"cut_1_2, cut_2_3, ...", "rising",
                    "Boundaries between the points of the rating scale, from its good end on."});
  }
  std::printf("%s", text_table(rows).c_str());
}

/// What a file says beside its parameters.
void print_settings(const ObserverKind& kind) {
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](const std::string& name, const OrderedJson& schema) {
    std::string options;
    for (const OrderedJson& option : schema.value("enum", OrderedJson::array())) {
      options += (options.empty() ? " " : ", ") + option.get<std::string>();
    }
    rows.push_back({name, schema.value("description", std::string()) +
                              (options.empty() ? "" : " One of" + options + ".")});
  };
  const OrderedJson none{{"properties", OrderedJson::object()}};
  const OrderedJson& all = kind.settings.schema.is_null() ? none : kind.settings.schema;
  for (const auto& each : all["properties"].items()) {
    add(each.key(), each.value());
    const OrderedJson& group = each.value().contains("properties") ? each.value() : none;
    for (const auto& inner : group["properties"].items()) {
      add("  " + inner.key(), inner.value());
    }
  }
  std::printf("%s", rows.empty() ? "" : (text_table(rows) + "\n").c_str());
}

int explain_observer(const std::string& name) {
  const std::vector<std::string> shipped = shipped_names();
  const bool is_shipped = std::find(shipped.begin(), shipped.end(), name) != shipped.end();
  const ObserverKind* kind = find_observer_kind(name);
  if (!is_shipped && kind != nullptr && !fs::exists(name)) {
    std::printf("%s: a kind of simulated participant\n%s\n\n", name.c_str(), kind->words.c_str());
    print_settings(*kind);
    print_parameters(*kind, nullptr);
    return kDone;
  }
  if (!is_shipped && !fs::exists(name)) {
    throw InputError("expected a file, a kind, or a simulated participant (" + listed(shipped) +
                     "), got " + name);
  }
  const ObserverFile file = named_observer(name);
  std::printf("%s\n%s\n", file.document.name.c_str(), file.kind->words.c_str());
  if (file.document.value.contains("note")) {
    std::printf("%s\n", file.document.value["note"].get<std::string>().c_str());
  }
  std::printf("It looks at %s.\n\n", attention_of(file).words.c_str());
  print_parameters(*file.kind, &file.document.value["parameters"]);
  return kDone;
}

int tell_of_observers(const std::string& name) {
  return name.empty() ? list_observers() : explain_observer(name);
}

}  // namespace

void add_observers(CLI::App& app, Command& chosen) {
  const auto [command, name] = add_command<std::string>(
      app, chosen, tell_of_observers, "observers",
      "The simulated participants that there are, and what they are made of");
  command->add_option("name", *name, "One of them, or a file: all of its parameters");
}

}  // namespace impetus::inline commands
