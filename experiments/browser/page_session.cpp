// A session in a page: what `impetus run` is in a lab.
//
//   /study.json  what was published   ─┐
//   /facts.json  who, which screen     ├─> refresh, plan ─> run_session ─> lines
//   /standing.json  what was done      │
//   /trees       trees that take long ─┘
//
// The page puts these files into the program's own, empty file system before it calls run_page().
// SPDX-License-Identifier: MIT
#include <emscripten.h>
#include <emscripten/html5.h>

#include <exception>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "experiments/browser/page_laboratory.hpp"
#include "experiments/browser/the_page.hpp"
#include "experiments/lines/published_study.hpp"
#include "experiments/lines/standing.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/participant_code.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/session/resumption.hpp"
#include "experiments/session/session.hpp"

namespace impetus::inline browser {
namespace {

using nlohmann::json;

/// What the page knows of the participant and of itself.
struct Facts {
  std::string participant;
  std::uint64_t seed{1};
  std::string machine;
  std::string display;
  ScreenGeometry screen;
  bool screen_measured{false};
  bool allow_failed_sync{false};
};

ScreenGeometry screen_from(const json& said) {
  ScreenGeometry screen;
  screen.width_m = said.at("width_m").get<double>();
  screen.height_m = said.at("height_m").get<double>();
  screen.width_px = said.at("width_px").get<int>();
  screen.height_px = said.at("height_px").get<int>();
  screen.viewing_distance_m = said.at("viewing_distance_m").get<double>();
  return screen;
}

Facts facts_from(const json& said) {
  Facts facts{said.at("participant").get<std::string>(),
              said.at("seed").get<std::uint64_t>(),
              said.at("machine").get<std::string>(),
              said.at("display").get<std::string>(),
              screen_from(said.at("screen")),
              said.at("screen_measured").get<bool>(),
              said.at("allow_failed_sync").get<bool>()};
  if (!is_participant_code(facts.participant)) {
    throw std::runtime_error("this link has no code that can stand in a study: " +
                             facts.participant);
  }
  return facts;
}

/// On the page's canvas; opaque, and smoothed by the painters alone.
void make_context() {
  EmscriptenWebGLContextAttributes wanted;
  emscripten_webgl_init_context_attributes(&wanted);
  wanted.majorVersion = 2;
  wanted.alpha = EM_FALSE;
  wanted.antialias = EM_FALSE;
  wanted.preserveDrawingBuffer = EM_TRUE;
  const auto context = emscripten_webgl_create_context("#picture", &wanted);
  if (context <= 0 || emscripten_webgl_make_context_current(context) != EMSCRIPTEN_RESULT_SUCCESS) {
    throw std::runtime_error("this browser does not draw with WebGL 2, which the study needs");
  }
  emscripten_webgl_enable_extension(context, "EXT_color_buffer_float");
}

SessionRecord session_record(const Facts& facts, const Protocol& protocol,
                             const PageLaboratory& page, const SyncTest& sync,
                             const PublishedStudy& study) {
  SessionRecord session;
  session.participant = facts.participant;
  session.seed = facts.seed;
  session.protocol_hash = protocol.hash;
  session.build = study.build + "; in a page: WebAssembly, " IMPETUS_PAGE_COMPILER;
  session.machine = facts.machine;
  session.display = facts.display;
  session.screen = page.geometry();
  session.screen_measured = facts.screen_measured;
  session.refresh_hz = page.refresh_hz();
  session.sync = sync;
  session.gaze_source = protocol.script.gaze ? page.source() : "";
  return session;
}

/// Where the participant stands: at the beginning, or where an earlier page was left.
Standing standing_of(const json& said, const Plan& plan, const Protocol& protocol) {
  if (said.is_null()) {
    return {plan, {}};
  }
  const ResumeRule& rule = protocol.script.resume;
  const double age_h = said.at("age_s").get<double>() / 3600.0;
  if (rule.refuse_after_h > 0.0 && age_h > rule.refuse_after_h) {
    throw std::runtime_error("this study was left too long ago to go on with it");
  }
  Standing standing = standing_from(said.at("standing"), plan, protocol.design);
  resume(protocol.script, standing.plan, standing.history);
  return standing;
}

void hand_over_session(const SessionRecord& session, const Plan& plan) {
  hand_over(line_of(session));
  for (const PlannedTrial& trial : plan) {
    hand_over(line_of(trial));
  }
}

/// What a page says of how a session ended.
const char* name_of(SessionEnding ending) {
  switch (ending) {
    case SessionEnding::kFinished:
      return "finished";
    case SessionEnding::kDeclined:
      return "declined";
    default:
      return "quit";
  }
}

std::string run() {
  const PublishedStudy study = published_study_from(read_json("/study.json").value);
  const Facts facts = facts_from(read_json("/facts.json").value);
  const Protocol protocol = protocol_of(study, std::make_shared<ShapeLibrary>(TreeCache("/trees")));
  make_context();
  const SteadyClock clock;
  PageLaboratory page(facts.screen, clock);
  const SyncTest sync = page.measure_refresh();
  const bool steady = sync.passed || facts.allow_failed_sync;
  if (steady) {
    check_frames(protocol, page.refresh_hz(), /*allow_rounding=*/false);
  }
  const Plan plan = plan_of(study, protocol, facts.participant, facts.seed);
  hand_over_session(session_record(facts, protocol, page, sync, study), plan);
  const Standing standing = standing_of(read_json("/standing.json").value, plan, protocol);
  PageRecorder recorder(standing, protocol.design);
  if (!steady) {
    recorder.save(NoteRecord{kSyncTestFailedNote, sync.verdict});
    recorder.await_saved();
    throw std::runtime_error(protocol.script.language.text("page_unsteady"));
  }
  const ProtocolScenes scenes(protocol, kUnroundedHold);
  const GazePaths no_paths;
  const Ports ports{page, page, scenes, recorder, &page, &clock, &clock, &no_paths};
  const SessionResult result =
      run_session(protocol.script, standing.plan, standing.history, ports, protocol.design);
  return name_of(result.ending);
}

}  // namespace
}  // namespace impetus::inline browser

/// Runs a session to its end; says in the page why it cannot. Returns "finished", "declined",
/// "quit" or "failed", to be read before the next call.
extern "C" EMSCRIPTEN_KEEPALIVE const char* run_page() {
  static std::string ending;
  try {
    ending = impetus::run();
  } catch (const std::exception& error) {
    impetus::tell(error.what());
    ending = "failed";
  }
  return ending.c_str();
}
