// What is made of rows of settings: schemas, structs and the keys of what may be changed.
// SPDX-License-Identifier: MIT
#include "experiments/settings/setting_rows.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "experiments/settings/schema_sentences.hpp"

namespace impetus::setting_rows_test {
namespace {

using nlohmann::json;

enum class Gait { kWalk, kRun };

struct Leg {
  double length_m{0.5};
};

struct Animal {
  Leg leg;
  int legs{4};
  std::optional<double> speed_m_s;
  Gait gait{Gait::kWalk};
};

Kind<Animal> animal_kind() {
  return object<Animal>(
      "", {required("legs", &Animal::legs, whole<int>({0, 1000}), "How many."),
           row("length_m", &Animal::leg, &Leg::length_m, number(above(0, 3)))
               .with("length", "of each leg"),
           row("speed_m_s", &Animal::speed_m_s, number({0, 100})),
           row("gait", &Animal::gait, choice<Gait>({{"walk", Gait::kWalk}, {"run", Gait::kRun}}))});
}

TEST(SettingRows, WhatIsLeftOutKeepsItsMembersInitialValue) {
  const Animal animal = animal_kind().read(json::parse(R"({"legs": 2})"));
  EXPECT_EQ(animal.legs, 2);
  EXPECT_EQ(animal.leg.length_m, 0.5);
  EXPECT_FALSE(animal.speed_m_s);
  EXPECT_EQ(animal.gait, Gait::kWalk);
}

TEST(SettingRows, WhatIsSaidIsRead) {
  const Animal animal = animal_kind().read(
      json::parse(R"({"legs": 6, "length_m": 1, "speed_m_s": 0.25, "gait": "run"})"));
  EXPECT_EQ(animal.leg.length_m, 1.0);
  EXPECT_EQ(animal.speed_m_s, 0.25);
  EXPECT_EQ(animal.gait, Gait::kRun);
}

TEST(SettingRows, TheSchemaIsWhatTheRowsSay) {
  EXPECT_EQ(json(animal_kind().schema), json::parse(R"({
    "type": "object",
    "additionalProperties": false,
    "required": ["legs"],
    "properties": {
      "legs": {"description": "How many.", "type": "integer", "minimum": 0, "maximum": 1000},
      "length_m": {"type": "number", "exclusiveMinimum": 0, "maximum": 3},
      "speed_m_s": {"type": "number", "minimum": 0, "maximum": 100},
      "gait": {"enum": ["walk", "run"]}
    }
  })"));
}

TEST(SettingRows, RefusalsAreInTheWordsOfTheRows) {
  const json schema = animal_kind().schema;
  const auto refusal = [&](const char* text) {
    const auto problem = find_schema_problem(schema, json::parse(text));
    return problem ? problem->pointer + ": " + problem->message : "accepted";
  };
  EXPECT_EQ(refusal(R"({"legs": 2, "length_m": 0})"),
            "/length_m: expected a number > 0 and ≤ 3, got 0");
  EXPECT_EQ(refusal(R"({"legs": 2, "gait": "swim"})"),
            "/gait: expected one of \"walk\", \"run\", got \"swim\"");
  EXPECT_EQ(refusal("{}"), ": expected the key \"legs\", which is missing");
}

TEST(SettingRows, AKeyOfWithLeadsToItsRowThroughAllThatHoldsIt) {
  struct Zoo {
    Animal animal;
  };
  const Kind<Zoo> zoo = object<Zoo>("", {row("animal", &Zoo::animal, animal_kind())});
  ASSERT_EQ(zoo.with.size(), 1U);
  EXPECT_EQ(zoo.with.front().key, "length");
  EXPECT_EQ(zoo.with.front().pointer, "/animal/length_m");
}

TEST(SettingRows, ADefinitionIsReferredToAndKeptByTheWhole) {
  struct Herd {
    std::vector<Animal> animals;
  };
  const Kind<Herd> herd =
      object<Herd>("", {row("animals", &Herd::animals,
                            list(defined("animal", animal_kind(), "One of them."), {1, 9}))});
  EXPECT_EQ(json(herd.schema["properties"]["animals"]), json::parse(R"({
    "type": "array", "minItems": 1, "maxItems": 9, "items": {"$ref": "#/definitions/animal"}})"));
  EXPECT_EQ(herd.definitions["animal"]["description"], "One of them.");
}

struct Swimmer {
  double depth_m{1.0};
};

/// What it can do besides begins elsewhere in it than it does.
struct Duck : Animal, Swimmer {
  Leg wing;
};

TEST(SettingRows, OfBasesAndOfWhatIsWithinAreReadIntoTheirPlaces) {
  const RowList<Swimmer> of_swimmers{row("depth_m", &Swimmer::depth_m, number({0, 9}))};
  const RowList<Leg> of_wings{row("wing_m", &Leg::length_m, number({0, 9}))};
  RowList<Duck> rows{row("speed_m_s", &Duck::speed_m_s, number({0, 100}))};
  rows.append_base(of_swimmers).append_within(&Duck::wing, of_wings);
  rows.append(row("dives_m", &Duck::depth_m, number({0, 99})));  // a base's, as C++ has it
  const Duck duck = object<Duck>("", rows).read(
      json::parse(R"({"speed_m_s": 3.0, "depth_m": 2.0, "wing_m": 0.25})"));
  EXPECT_EQ(duck.speed_m_s, 3.0);
  EXPECT_EQ(duck.depth_m, 2.0);
  EXPECT_EQ(duck.wing.length_m, 0.25);
  EXPECT_EQ(duck.leg.length_m, 0.5);
  EXPECT_EQ(object<Duck>("", rows).read(json::parse(R"({"dives_m": 7.0})")).depth_m, 7.0);
}

TEST(SettingRows, ARowForPeopleAloneStaysSoWhereverItIsPut) {
  const RowList<Leg> of_legs{unread<Leg>("colour", text(), "For people.")};
  RowList<Animal> rows{required("legs", &Animal::legs, whole<int>({0, 1000}))};
  const auto kind = object<Animal>("", rows.append_within(&Animal::leg, of_legs));
  EXPECT_EQ(kind.schema["properties"]["colour"]["description"], "For people.");
  EXPECT_EQ(kind.read(json::parse(R"({"legs": 3, "colour": "red"})")).legs, 3);
}

}  // namespace
}  // namespace impetus::setting_rows_test
