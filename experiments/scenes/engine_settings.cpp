// SPDX-License-Identifier: MIT
#include "experiments/scenes/engine_settings.hpp"

#include <algorithm>

namespace impetus::inline scenes {
namespace {

constexpr double kBillion = 1e9;

std::vector<std::string> texts(const std::vector<std::string_view>& views) {
  return {views.begin(), views.end()};
}

/// "depth-first, breadth-first, best-first, ..."
std::string first_three(const std::vector<std::string_view>& names) {
  std::string words;
  for (std::size_t i = 0; i < 3 && i < names.size(); ++i) {
    words += std::string(names[i]) + ", ";
  }
  return words + "...";
}

Kind<WeightedTerm> term_kind() {
  std::vector<std::string> metrics = texts(metric_names());
  std::erase_if(metrics, [](const std::string& name) { return needs_terms(name); });
  const Kind<double> measure = number({-kBillion, kBillion});
  return object<WeightedTerm>(
      "", {required("metric", &WeightedTerm::metric, one_of(metrics)),
           row("weight", &WeightedTerm::weight, number(above(0, 1e6)), "1 when left out."),
           required("urgent", &WeightedTerm::urgent, measure, "In the metric's own unit."),
           required("relaxed", &WeightedTerm::relaxed, measure, "In the metric's own unit.")});
}

/// Said in numbers, or by a file that holds them, which is put in when a scene is read.
Kind<WhoNotices> noticing_kind() {
  using N = WhoNotices;
  const Kind<N> numbers = object<N>(
      "",
      {required("threshold_arcmin", &N::threshold_arcmin, number(above(0, 10000)),
                "The gap that is noticed half of the time where one looks, at rest, with two "
                "bodies."),
       row("crowding_per_body", &N::crowding_per_body, number({0, 100}),
           "Share by which it rises for each body beyond two; 0 when left out."),
       required("width_log10", &N::width_log10, number({1e-3, 10}),
                "How wide its function is: a standard deviation of the gap's decimal logarithm."),
       required("miss_rate", &N::miss_rate, number({0, 0.99}),
                "The share of the largest gaps that goes unnoticed.")});
  Kind<N> kind = numbers;
  kind.schema["type"] = {"object", "string"};
  kind.read = [numbers](const nlohmann::json& said) {
    return said.is_object() ? numbers.read(said) : N{};
  };
  return kind;
}

Kind<PriorityList> list_kind() {
  return object<PriorityList>(
      "",
      {row("share", &PriorityList::share, number(above(0, 1e6)),
           "Of a step's work beyond the coarsest levels, relative to the other lists; 1 when left "
           "out."),
       row("least_level", &PriorityList::least_level, level_kind(),
           "Reached whatever the budget; 0 when left out."),
       row("greatest_level", &PriorityList::greatest_level, level_kind(),
           "Never exceeded; the trees' deepest when left out.")});
}

/// Limits of the list rule of this name.
Row<ScheduleSettings> limits_row(const std::string& rule) {
  const ListLimits& said = *make_list_rule(rule)->limits();
  const Kind<std::vector<double>> limits =
      list(number({said.least, said.most}), {0, kMostLists - 1});
  return {rule, limits, said.words,
          [rule, read = limits.read](const nlohmann::json& value, ScheduleSettings& into) {
            into.limits[rule] = read(value);
          }};
}

Kind<ScheduleSettings> schedule_kind() {
  using S = ScheduleSettings;
  std::vector<std::string> schedulers = texts(metric_names());
  schedulers.emplace_back(kRegionScheduler);
  std::sort(schedulers.begin(), schedulers.end());
  RowList<S> rows{
      required("scheduler", &S::scheduler, one_of(schedulers),
               "What decides a pair's list: a metric against thresholds, or, of region, whether "
               "it lies inside. " +
                   metrics_in_words())
          .with("scheduler",
                "distance, eccentricity, ..., region, with lists of its own:\n"
                "    one, from the coarsest level to the finest, or those by\n"
                "    shares of the pairs; of region the finest inside, the\n"
                "    coarsest outside"),
      row("point_deg", &S::point_deg,
          screen_place_kind(
              "For eccentricity, perceived, visible-frequency and weighted sums of them: "
              "degrees are counted from this point of the screen, wherever the "
              "viewer looks.")),
      row("terms", &S::terms, list(term_kind(), {1, 16}),
          "Of the scheduler weighted: each metric counts 1 at urgent and beyond, 0 at relaxed and "
          "beyond, linear between them, times its weight."),
      row("noticing", &S::noticing, noticing_kind(),
          "Who notices gaps, for the scheduler perceived and for that term of a sum; others do not "
          "ask. The file of a gaze-contingent participant, as `impetus fit` writes it, or its "
          "numbers; left out: 10, 0, 0.2 and 0.1, which are assumed."),
      row("traversal", &S::traversal, one_of(texts(traversal_names())),
          "Which pair of a list gets the next work; " + std::string(traversal_names().front()) +
              " when left out. " + traversals_in_words())
          .with("traversal", first_three(traversal_names())),
      row("persistence_ms", &S::persistence_ms, number({0, 60000}),
          "A pair that touches keeps the highest priority it had for so long, against popping; a "
          "whole number of steps, 0 when left out.")
          .with("persistence-ms", "how long a pair keeps its priority"),
      required("lists", &S::lists, list(list_kind(), {1, kMostLists}),
               "From high priority to low; the scheduler region takes two, inside and outside.")};
  for (const std::string& rule : limited_list_rule_names()) {
    rows.append(limits_row(rule));
  }
  return object<S>(
      "Which collisions are refined first, and how deep. Left out: one list, nearest first, to the "
      "finest level.",
      rows);
}

Kind<RegionSettings> region_kind() {
  using R = RegionSettings;
  return object<R>(
      "For the scheduler region: where collisions are of high priority.",
      {required("kind", &R::kind, choice(region_names()),
                "all-good: everywhere. all-bad: nowhere. tracked: about the gaze. random: about "
                "places drawn within the enclosure's image. fixed: about a point of the screen. "
                "recorded: about another participant's recorded gaze, which a protocol's "
                "gaze/yoked_to names.")
           .with("region", "all-good, all-bad, tracked, random"),
       row("point_deg", &R::point_deg, screen_place_kind("Of kind fixed: its centre.")),
       required("radius_deg", &R::radius_deg, number(above(0, 90)))
           .with("radius-deg", "of the region"),
       row("renewal_ms", &R::renewal_ms, number(above(0, 60000)),
           "Of kind random: how long a place lasts; a whole number of steps. 250 when left out.")});
}

Kind<BudgetSettings> budget_kind() {
  using B = BudgetSettings;
  const Names<WorkCosts> counts{{"tests", WorkCosts{}}, {"all-phases", kAllPhases}};
  return object<B>(
      "How much a step may do: units of work beyond the coarsest level of every pair, or "
      "milliseconds "
      "for all of it; unlimited when left out.",
      {row("counts", &B::counts, choice(counts),
           "What is work. tests, when left out: node-pair tests, each one unit. all-phases: tests, "
           "contacts modelled and contacts responded to, in units of the test of two spheres "
           "(engine/scheduling/work_costs.hpp).")
           .with("counts", "what is work: tests, all-phases"),
       row("tests_per_step", &B::tests_per_step, whole<std::int64_t>({0, kBillion}),
           "Units of work: the same on every machine.")
           .with("budget", "units of work a step, or unlimited"),
       row("ms_per_step", &B::ms_per_step, number(above(0, 1000)),
           "Milliseconds by the clock; the work that was granted is recorded, and a replay grants "
           "the same.")});
}

Kind<TreeSettings> tree_settings_kind() {
  using T = TreeSettings;
  return object<T>(
      "What kind of volume tree bodies have, beside tree_depth; an octree of spheres when left "
      "out.",
      {required("kind", &T::kind, kind_of_trees())
           .with("tree", "kind of the volume trees: octree, medial, ..."),
       row("branching", &T::branching, whole<int>({kLeastBranching, kGreatestBranching}),
           "Children of a node, at most; 8 when left out. An octree has 8; voxels 8, 27 or 64.")
           .with("branching", "children of a node, at most")});
}

Kind<ContactSettings> contacts_kind() {
  using C = ContactSettings;
  return object<C>(
      "How the contacts of a pair's overlapping nodes become the few that the response gets.",
      {row("reduction", &C::reduction, one_of(texts(reduction_names())),
           "none: all of them. first: the one entered first. average: their mean, when left out. "
           "groups: a mean for each pair of surface groups. density: groups, with normals from the "
           "density gradients. weighted: groups, weighted by interpenetration and occupancy.")
           .with("reduction", "of contacts: average, groups, ..."),
       row("most_per_pair", &C::most_per_pair, whole<int>({1, 64}),
           "Of what the reduction leaves, at most so many, those that span most torque; 4 when "
           "left out.")
           .with("contacts", "contacts of a pair, at most")});
}

Kind<MaterialPair> material_pair_kind() {
  using M = MaterialPair;
  return object<M>("", {required("pair", &M::pair, several<2>(material_kind())),
                        required("restitution", &M::restitution, number({0, 1}))});
}

RowList<EngineSettings> rows_of_contacts() {
  using E = EngineSettings;
  using W = WorldSettings;
  return {
      required("step_hz", &E::step_hz, number({10, 100000}),
               "Steps per second of simulated time; never depends on the display."),
      required("restitution", &E::world, &W::restitution, number({0, 1}),
               "Of all contacts but those that materials speaks of.")
          .with("restitution", "of all contacts but those of materials"),
      row("materials", &E::materials, list(material_pair_kind(), {}),
          "Restitutions of pairs of materials, in either order; bodies, a crowd and the enclosure "
          "may name theirs."),
      row("contacts", &E::contacts, contacts_kind()),
      row("tunnelling", &E::world, &W::tunnelling,
          choice<Tunnelling>({{"ignored", Tunnelling::kIgnored},
                              {"capped", Tunnelling::kCapped},
                              {"stop-at-entry", Tunnelling::kStopAtEntry}}),
          "Of bodies that move further in a step than they are thick. ignored: they are tested "
          "where the step ends, and may pass through each other. capped: they stay at levels whose "
          "nodes are thicker than the way. stop-at-entry, when left out: they are tested along "
          "their way, and stop where they first touch.")
          .with("tunnelling", "ignored, capped, stop-at-entry"),
      row("most_entry_tests", &E::world, &W::most_entry_tests, whole<std::int64_t>({0, kBillion}),
          "Where fast bodies stop at entry: node pairs that are tested along their ways in a step, "
          "at most: a budget in units does not limit them, one in milliseconds does. Fast pairs "
          "for which none are left stay at levels "
          "whose nodes are thicker than the way. Without limit when left out."),
      row("response", &E::world, &W::response,
          choice<ResponseMethod>(
              {{"in-turn", ResponseMethod::kInTurn}, {"together", ResponseMethod::kTogether}}),
          "How impulses are found where bodies touch several others: contact by contact (in-turn, "
          "when left out), or together, after which nothing approaches any more.")
          .with("response", "in-turn, together"),
      row("rotation", &E::world, &W::rotation,
          choice<Rotation>(
              {{"midpoint", Rotation::kMidpoint}, {"energy-kept", Rotation::kEnergyKept}}),
          "How rotation is stepped; both keep angular momentum. midpoint, when left out: the "
          "energy swings about its value, by 1e-4 or so. energy-kept: to rounding, for four times "
          "the iterations.")
          .with("rotation", "midpoint, energy-kept"),
      row("response_passes", &E::world, &W::most_response_passes, whole<int>({1, 1000}),
          "Over the contacts of bodies that affect each other, in a step: the response never does "
          "more, and what still approaches is left to the next step. Left out: until nothing "
          "approaches.")
          .with("passes", "of the response, at most"),
      row("gravity_m_s2", &E::gravity_m_s2, vector({-1000, 1000}),
          "Of every body that can move; none when left out. y is up.")};
}

RowList<EngineSettings> rows_of_detail() {
  using E = EngineSettings;
  return {row("tree_depth", &E::tree_depth, whole<int>({0, 6}),
              "Levels of a body's volume tree beyond its root; a sphere needs none, and a study "
              "builds none that no condition of it can reach.")
              .with("depth", "levels of the trees beyond their root"),
          row("tree", &E::tree, tree_settings_kind()),
          row("level", &E::level, level_kind(),
              "The level of detail at which collisions are handled: 0 is the root sphere. A "
              "schedule says more, in its place.")
              .with("level", "the one level at which all collisions are handled"),
          row("schedule", &E::schedule, schedule_kind()),
          row("region", &E::region, region_kind()),
          row("budget", &E::budget, budget_kind())};
}

}  // namespace

EngineSettings::EngineSettings(const nlohmann::json& valid)
    : EngineSettings(engine_kind().read(valid)) {}

const Kind<EngineSettings>& engine_kind() {
  static const Kind<EngineSettings> kind = [] {
    RowList<EngineSettings> rows = rows_of_contacts();
    return object<EngineSettings>("How the world is stepped.", rows.append(rows_of_detail()));
  }();
  return kind;
}

Kind<int> level_kind() { return defined("level", whole<int>({0, 6})); }

Kind<std::string> material_kind() {
  return defined("material", text(), "A name, for the restitutions of engine.materials.");
}

Kind<ScreenPlace> screen_place_kind(const std::string& sentence) {
  const Kind<ScreenPlace> place =
      defined("screen_point", several<2>(number({-90, 90})),
              "Right of the screen's centre and above it, where a body of such a position would "
              "be.");
  return {described(sentence, place), place.read};
}

Kind<TreeKind> kind_of_trees() {
  return {one_of(tree_kind_names()),
          [](const nlohmann::json& value) { return tree_kind(value.get<std::string>()); }};
}

const Names<RegionKind>& region_names() {
  static const Names<RegionKind> names{
      {"all-good", RegionKind::kAllGood}, {"all-bad", RegionKind::kAllBad},
      {"tracked", RegionKind::kTracked},  {"random", RegionKind::kRandom},
      {"fixed", RegionKind::kFixed},      {"recorded", RegionKind::kRecorded}};
  return names;
}

}  // namespace impetus::inline scenes
