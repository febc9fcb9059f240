// SPDX-License-Identifier: MIT
#include "experiments/protocol/protocol_rows.hpp"

#include <algorithm>
#include <utility>

#include "experiments/protocol/instrument_rows.hpp"
#include "experiments/protocol/protocol_language.hpp"
#include "experiments/protocol/solved_values.hpp"
#include "experiments/questions/answer_keys.hpp"
#include "experiments/questions/level_value.hpp"
#include "experiments/questions/question_order.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/settings/schema_sentences.hpp"

namespace impetus::inline protocol {
namespace {

using P = Protocol;
using S = Script;

constexpr ListLength kSome{1, -1};
constexpr ListLength kSomeUnlike{1, -1, /*is_set=*/true};

Kind<std::int64_t> count(double least, double most = NumberRange{}.most) {
  return whole<std::int64_t>({least, most});
}

Kind<std::string> id_kind() { return text_like("^[a-z][a-z0-9_]*$"); }

// ---------------------------------------------------------------- the design

/// Any values by JSON Pointer, kept as text.
Kind<std::string> values_kind() {
  return {{{{"type", "object"}, {"minProperties", 1}, {"propertyNames", {{"pattern", "^/"}}}}},
          [](const nlohmann::json& values) { return values.dump(); }};
}

Kind<Factor> factor_kind() {
  using F = Factor;
  return object<F>(
      "",
      {required("name", &F::name, id_kind()), row("label", &F::label, any_text()),
       row("pointer", &F::pointer, text_like("^/"),
           "JSON Pointer to the value in the scene that the factor overrides."),
       row("sets", &F::sets, by_name(values_kind()),
           "In place of a pointer, for a factor that changes several values at once: what each "
           "level, a word, puts into the scene, by JSON Pointer."),
       row("keys_of", &F::keys_of, text(),
           "In place of a pointer: the question (yes_no, two_interval, choice) whose answers "
           "have other keys at each level: \"f j\", \"j f\". Each key keeps its side of the "
           "screen."),
       row("between", &F::between, flag(),
           "Between participants: each has one level, of those that the fewest have so far, drawn "
           "by the seed and the participant's code and kept with the plan; false when left out. "
           "Practice and catch trials, which do not name the factor, have the same level."),
       required("levels", &F::levels, list(own_level_kind(), kSomeUnlike),
                "null is the scene's own value.")});
}

Kind<LongestRun> longest_run_kind() {
  using L = LongestRun;
  return object<L>(
      "", {required("factor", &L::factor, any_text()), required("longest", &L::longest, count(1))});
}

Kind<Blocks> blocks_kind() {
  using B = Blocks;
  return object<B>(
      "Trials come in blocks: one for each combination of the factors' levels, within which the "
      "other factors vary; or so many alike.",
      {row("count", &B::count, count(2, 1000),
           "Blocks alike, in place of factors and order: each has every cell equally often, so "
           "that their number divides the repetitions, or the trials of a track."),
       row("factors", &B::factors, list(any_text(), kSomeUnlike)),
       row("order", &B::order,
           choice<B::Order>({{"random", B::Order::kRandom},
                             {"fixed", B::Order::kFixed},
                             {"latin-square", B::Order::kLatinSquare}}),
           "random: drawn. fixed: as listed. latin-square: a row of a square that "
           "counterbalances first-order effects (Williams 1949), by the number at the end of "
           "the participant's code.")});
}

Kind<CatchTrials> catch_kind() {
  using C = CatchTrials;
  return object<C>(
      "", {required(
               "condition", &C::condition, condition_kind(),
               "A level for every factor within participants; it need not be one of the design's."),
           required("count", &C::count, count(1, 1000), "In each block.")});
}

Kind<Adaptation> adaptation_kind() {
  using A = Adaptation;
  const Kind<std::int64_t> some = count(0, 10000);
  return object<A>(
      "Trials of which nothing is asked, so that what is seen after them is seen after them; never "
      "pooled, and without fixation (timing/between_adaptors_ms).",
      {required("when", &A::when, condition_kind(), "Levels of the trials that they precede."),
       required("conditions", &A::conditions, list(condition_kind(), kSome),
                "Shown in turn: a level for every factor within participants, which need not be "
                "one of the design's."),
       required("first", &A::first, some, "Before the first such trial of each block."),
       required("before_each", &A::before_each, some, "Before each other one.")});
}

Kind<Staircase> staircase_kind() {
  using U = Staircase;
  const Kind<double> any = number({});
  return object<U>(
      "Up-down (Levitt 1971).",
      {required("up", &U::up, count(1, 10), "Negatives in a row that make it easier."),
       required("down", &U::down, count(1, 10), "Positives in a row that make it harder."),
       row("steps", &U::steps, list(count(1, 1000), kSome),
           "In levels: the next one is used after each reversal, the last one for ever. 1 when "
           "left out."),
       required("starts", &U::starts, list(Kind<LevelValue>{any, any.read}, {1, 8}),
                "The level at which each of the interleaved staircases begins.")});
}

Kind<QuestPlus> quest_plus_kind() {
  using Q = QuestPlus;
  const auto grid = defined("grid", list(number({-1e6, 1e6}), {1, 1000, /*is_set=*/true}));
  return object<Q>(
      "QUEST+ (Watson 2017), with a uniform prior over these grids. Slopes are exponents of a "
      "Weibull function, standard deviations of a normal one. Levels rise from hard to easy.",
      {required("function", &Q::function,
                choice<Q::Function>(
                    {{"weibull", Q::Function::kWeibull}, {"normal", Q::Function::kNormal}})),
       required("scale", &Q::scale,
                choice<Q::Scale>({{"linear", Q::Scale::kLinear},
                                  {"log10", Q::Scale::kLog10},
                                  {"decibel", Q::Scale::kDecibel}}),
                "What threshold and slope are counted in: the level itself, its decimal "
                "logarithm, or decibels (20 log10)."),
       required("thresholds", &Q::thresholds, grid), required("slopes", &Q::slopes, grid),
       required("guess_rates", &Q::guess_rates, grid),
       required("lapse_rates", &Q::lapse_rates, grid)});
}

Kind<Adaptive> adaptive_kind() {
  using A = Adaptive;
  return object<A>(
      "One factor's level is chosen trial by trial from its levels, listed from hard to easy; one "
      "track for each combination of the other factors' levels.",
      {required("factor", &A::factor, any_text()),
       required("trials_per_track", &A::trials_per_track, count(1, 10000)),
       row("staircase", &A::method, staircase_kind()),
       row("quest_plus", &A::method, quest_plus_kind())});
}

Kind<PracticeRule> practice_rule_kind() {
  using R = PracticeRule;
  return object<R>(
      "Practice is repeated until, in one round, something was clicked in a trial of the worst "
      "level (where clicks are asked for) and the best level was rated better on average.",
      {required("factor", &R::factor, any_text()), required("best", &R::best, own_level_kind()),
       required("worst", &R::worst, own_level_kind()),
       required("rounds", &R::rounds, count(1, 20),
                "At most; after the last the experimenter decides.")});
}

Kind<TrainingRule> training_rule_kind() {
  using R = TrainingRule;
  return object<R>(
      "In place of practice_until, where answers are right or wrong: practice goes on, its "
      "conditions in order again and again, until of the last so many trials enough were answered "
      "right. Each answer is said to be right or wrong.",
      {required("right", &R::right, count(1, 100)), required("of", &R::of, count(1, 100)),
       required("most_trials", &R::most_trials, count(1, 1000),
                "After these the experimenter decides.")});
}

RowList<P> design_rows() {
  using D = Design;
  return {required("factors", &P::design, &D::factors, list(factor_kind(), kSome)),
          required("repetitions", &P::design, &D::repetitions, count(1, 1000)),
          row("longest_runs", &P::design, &D::longest_runs, list(longest_run_kind(), {}),
              "At most so many trials in a row with the same level of the factor."),
          row("blocks", &P::design, &D::blocks, blocks_kind()),
          row("catch_trials", &P::design, &D::catch_trials, list(catch_kind(), {}),
              "Trials outside the design, spread among the main ones and never pooled with them."),
          row("adaptation", &P::design, &D::adaptation, list(adaptation_kind(), {1, 20})),
          row("adaptive", &P::design, &D::adaptive, adaptive_kind()),
          row("practice", &P::design, &D::practice, list(condition_kind(), {}),
              "Conditions shown first, in this order, with feedback on use of the scale."),
          row("practice_until", &P::script, &S::practice_rule, practice_rule_kind()),
          row("train_until", &P::script, &S::training_rule, training_rule_kind())};
}

// ---------------------------------------------------------------- the session

RowList<Text> text_rows() {
  return {required("title", &Text::title, text()),
          required("paragraphs", &Text::paragraphs, list(text(), {}))};
}

/// Title and paragraphs between other rows of what they belong to.
template <typename Struct>
RowList<Struct> rows_with_text(RowList<Struct> rows, Text Struct::*page,
                               const RowList<Struct>& more) {
  return rows.append_within(page, text_rows()).append(more);
}

Kind<Text> page_kind() { return defined("text", object<Text>("", text_rows())); }

Kind<Field> field_kind() {
  using F = Field;
  return object<F>(
      "", {required("id", &F::id, id_kind()), required("label", &F::label, text()),
           required("kind", &F::kind,
                    choice<F::Kind>({{"number", F::Kind::kNumber},
                                     {"choice", F::Kind::kChoice},
                                     {"text", F::Kind::kText}})),
           row("options", &F::options, list(text(), {2, -1})),
           row("minimum", &F::minimum, number({})), row("maximum", &F::maximum, number({}))});
}

Kind<Demonstration> demonstration_kind() {
  using D = Demonstration;
  return object<D>("", rows_with_text<D>({required("id", &D::id, id_kind())}, &D::text,
                                         {required("set", &D::set, by_name(factor_level_kind()),
                                                   "Values of the scene by JSON Pointer.")}));
}

Kind<LatenessRule> lateness_kind() {
  using L = LatenessRule;
  return object<L>(
      "When more than a share of the timed frames since the last break came late, or what was "
      "shown took longer than it should by more than that.",
      {required(
           "then", &L::then,
           choice<L::Then>({{"nothing", L::Then::kNothing},
                            {"tell", L::Then::kTell},
                            {"stop", L::Then::kStop}}),
           "tell, as when left out: a sentence on the terminal and a note in the study, at the "
           "next break and at the end. stop: at a break, and after practice, the session waits "
           "for the experimenter as well, who decides whether it goes on."),
       row("most_share", &L::most_share, number({0, 1}), "0.01 when left out.")});
}

Kind<ResumeRule> resume_kind() {
  using R = ResumeRule;
  return object<R>(
      "Where a session that was left goes on: at the next trial (as without this), or at the start "
      "of its block, whose trials done so far are set aside. Instructions are shown and the gaze "
      "is calibrated anew.",
      {required("at", &R::at, choice<R::At>({{"trial", R::At::kTrial}, {"block", R::At::kBlock}})),
       row("refuse_after_h", &R::refuse_after_h, number(above(0)),
           "Hours since anything was last recorded, after which it is not resumed at all.")});
}

Row<S> session_row() {
  const auto question = object<FreeQuestion>("", {required("id", &FreeQuestion::id, id_kind()),
                                                  required("text", &FreeQuestion::text, text())});
  return group<S>(
      "session",
      {required("welcome", &S::welcome, page_kind()),
       group<S>("consent",
                rows_with_text<S>({}, &S::consent,
                                  {required("statement", &S::consent_statement, text(),
                                            "What is agreed to, or not: shown apart, and stored "
                                            "with the answer.")}))
           .in_every_file(),
       row("demographics", &S::demographics, list(field_kind(), {}),
           "Asked once; each may be left empty."),
       required("instructions", &S::instructions, list(page_kind(), {})),
       row("demonstrations", &S::demonstrations, list(demonstration_kind(), {0, 100}),
           "Scenes shown before practice, each named first; not recorded as trials."),
       group<S>("breaks",
                rows_with_text<S>({row("every", &S::break_every, count(1),
                                       "Main trials between breaks; after each block when "
                                       "left out.")},
                                  &S::break_text, {})),
       row("resume", &S::resume, resume_kind()), row("late_frames", &S::lateness, lateness_kind()),
       row("questions", &S::questions, list(question, {}),
           "Asked after the last trial; answered in free text."),
       required("thanks", &S::thanks, page_kind()),
       row("light_pages", &S::light_pages, flag(),
           "Pages lighter than the stimuli; false, when left out: both have one mid-grey ground, "
           "so that eyes need not adapt between them."),
       row("progress_during_stimuli", &S::progress_during_stimuli, flag(),
           "How far the session has come is shown under stimuli, too; false, when left out: on "
           "pages and between trials alone.")});
}

Row<S> timing_row() {
  using T = TrialTiming;
  const Kind<double> duration = number({0, 60000});
  return row("timing", &S::timing,
             object<T>("", {required("fixation_ms", &T::fixation, fixation_time_kind(),
                                     "Fixation cross before the stimulus: a whole number of "
                                     "frames, or the least and the most, between which each "
                                     "stimulus has its own, drawn by the trial's seed."),
                            required("interval_ms", &T::interval_ms, duration,
                                     "Blank between trials, at least this long."),
                            row("between_adaptors_ms", &T::between_adaptors_ms, duration,
                                "The same before trials of adaptation; 0 when left out.")}));
}

const Kind<P>& protocol_kind() {
  static const Kind<P> kind = [] {
    RowList<P> rows{
        required("scene", &P::scene_file, text(),
                 "The scene's file, seen from this one, within the folder above this one's; links "
                 "are followed."),
        group<P>("design", design_rows()).in_every_file(),
        row("participants", &P::has_participants, choice<bool>({{"none", false}}),
            "none: nobody takes part; each trial is simulated to its end without a display. Left "
            "out: people or simulated participants, who need timing and session."),
        row("solve", &P::solve, list(solve_kind(), kSome),
            "Values of the scene that are computed before the plan is stored, by simulation, and "
            "kept with every trial; protocol and scene alone decide them."),
        row("exclude_when", &P::exclude_when, exclusion_rules_kind())};
    const RowList<S> instruments{question_order_row(), timing_row(), gaze_row(), markers_row(),
                                 session_row()};
    rows.append(language_rows())
        .append_within(&P::script, question_rows())
        .append_within(&P::script, instruments);
    return object<P>(
        "", rows_of_file<P>(rows, {required("name", &P::name, text_like("^[a-z][a-z0-9-]*$"),
                                            "Short and stable: the order of trials and the "
                                            "analysis go by it."),
                                   required("title", &P::title, text())}));
  }();
  return kind;
}

/// Puts the levels into the order of the design's factors.
void sort_levels(const Design& design, Condition& condition) {
  std::stable_sort(condition.begin(), condition.end(),
                   [&](const FactorLevel& a, const FactorLevel& b) {
                     return factor_place(design, a.factor) < factor_place(design, b.factor);
                   });
}

/// What the file says in another way than the struct does.
void complete(Protocol& protocol) {
  Design& design = protocol.design;
  for (Factor& factor : design.factors) {
    factor.label = factor.label.empty() ? factor.name : factor.label;
  }
  for (CatchTrials& kind : design.catch_trials) {
    sort_levels(design, kind.condition);
  }
  for (Adaptation& stream : design.adaptation) {
    for (Condition& condition : stream.conditions) {
      sort_levels(design, condition);
    }
  }
  for (Condition& condition : design.practice) {
    sort_levels(design, condition);
  }
  for (const Factor& factor : design.factors) {
    if (!factor.keys_of.empty()) {
      protocol.script.key_factors.push_back(key_factor(factor));
    }
  }
  if (protocol.script.practice_rule) {
    design.practice_rounds = protocol.script.practice_rule->rounds;
  }
  if (protocol.script.training_rule) {
    const auto round = static_cast<std::int64_t>(design.practice.size());
    design.most_practice_trials = protocol.script.training_rule->most_trials;
    design.practice_rounds = round > 0 ? (design.most_practice_trials + round - 1) / round : 0;
  }
}

}  // namespace

OrderedJson protocol_file_schema() {
  return file_schema("Impetus protocol",
                     "One study: a scene, a factorial design over its values, and what a "
                     "participant reads and answers.",
                     protocol_kind());
}

Protocol protocol_of(const nlohmann::json& document) {
  Protocol protocol = protocol_kind().read(document);
  complete(protocol);
  return protocol;
}

Protocol read_protocol(JsonDocument document) {
  static const nlohmann::json schema = protocol_file_schema();
  require_schema(document, schema);
  Protocol protocol = protocol_of(document.value);
  protocol.script.language = language_of(document);
  protocol.document = std::move(document);
  return protocol;
}

}  // namespace impetus::inline protocol
