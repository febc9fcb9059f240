// `impetus sessions`: who takes part in a study, how far they came, how each sitting went.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/settings/optional_json.hpp"
#include "experiments/store/read_only_file.hpp"
#include "experiments/store/session_list.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/tables/text_table.hpp"

namespace impetus::inline commands {
namespace {

using nlohmann::json;
using Rows = std::vector<std::vector<std::string>>;

/// "2026-11-22 10:04:12" of "2026-11-22T10:04:12.345Z".
std::string moment(const std::string& utc) {
  std::string words = utc.substr(0, 19);
  if (words.size() > 10) {
    words[10] = ' ';
  }
  return words;
}

/// "45 s", "23 min" or "3.2 h".
std::string span(double seconds) {
  return seconds < 120.0    ? printed("%.0f s", seconds)
         : seconds < 7200.0 ? printed("%.0f min", seconds / 60.0)
                            : printed("%.1f h", seconds / 3600.0);
}

std::string late_frames(const Participation& one) {
  const std::string counts =
      std::to_string(one.late_timed_frames) + " of " + std::to_string(one.timed_frames);
  const double late_percent =
      100.0 * static_cast<double>(one.late_timed_frames) / static_cast<double>(one.timed_frames);
  return one.late_timed_frames > 0 ? counts + printed(" (%.2g %%)", late_percent) : counts;
}

std::string ending(const ListedSession& sitting) {
  return !sitting.ending.empty() ? sitting.ending
         : sitting.running       ? "none yet: in use now"
                                 : "none: killed";
}

std::string resumption(const ListedSession& sitting) {
  if (!sitting.resumed) {
    return "-";
  }
  if (!sitting.resumed_after_s) {
    return "yes";
  }
  const double after_s = *sitting.resumed_after_s;
  return "at the " + sitting.resumed_at + ", " +
         (after_s < 0.0 ? "clock set back by " + span(-after_s) : "after " + span(after_s));
}

std::string sync_test(const ListedSession& sitting) {
  return sitting.sync_passed       ? (sitting.sync_tries == 0 ? "none: virtual time" : "passed")
         : sitting.sync_overridden ? "failed, overridden"
                                   : "failed";
}

std::string or_none(const std::string& text) { return text.empty() ? "-" : text; }

std::string title(const std::string& name, const SessionList& list) {
  std::set<std::string> people;
  std::set<std::string> simulated;
  std::set<std::string> protocols;
  for (const Participation& one : list.participations) {
    (one.simulated ? simulated : people).insert(one.participant);
    protocols.insert(one.protocol_hash);
  }
  std::string who =
      people.empty() ? "" : count_of(static_cast<std::int64_t>(people.size()), "person", "people");
  if (!simulated.empty()) {
    who += (who.empty() ? "" : ", ") + std::to_string(simulated.size()) + " simulated";
  }
  return printable(name) + ": " + who + "; " +
         count_of(static_cast<std::int64_t>(protocols.size()), "protocol") + "; times are UTC\n";
}

bool has_groups(const SessionList& list) {
  return std::any_of(list.participations.begin(), list.participations.end(),
                     [](const Participation& one) { return !one.group.empty(); });
}

/// With a column for groups where some protocol has factors between participants.
std::string participation_table(const SessionList& list) {
  Rows rows{{"participant", "kind", "protocol", "trials", "finished", "sittings", "interrupted",
             "set aside", "late frames", "merged from"}};
  const bool with_groups = has_groups(list);
  if (with_groups) {
    rows.front().push_back("group");
  }
  for (const Participation& one : list.participations) {
    rows.push_back({one.participant, one.simulated ? "simulated" : "person", one.protocol,
                    std::to_string(one.completed_trials) + "/" + std::to_string(one.planned_trials),
                    one.finished_utc.empty() ? "no" : moment(one.finished_utc),
                    std::to_string(one.sittings.size()), std::to_string(one.interrupted_attempts),
                    std::to_string(one.set_aside_attempts), late_frames(one),
                    or_none(one.merged_from)});
    if (with_groups) {
      rows.back().push_back(or_none(one.group));
    }
  }
  return text_table(rows);
}

std::string sitting_table(const SessionList& list) {
  Rows rows{{"participant", "protocol", "session", "began", "length", "ending", "resumed", "trials",
             "sync test", "gaze", "browser"}};
  for (const Participation& one : list.participations) {
    for (const ListedSession& sitting : one.sittings) {
      rows.push_back({one.participant, one.protocol, std::to_string(sitting.session),
                      moment(sitting.started_utc), span(sitting.length_s), ending(sitting),
                      resumption(sitting), std::to_string(sitting.completed_trials),
                      sync_test(sitting), or_none(sitting.gaze_source), or_none(sitting.browser)});
    }
  }
  return text_table(rows);
}

std::string left_out_table(const SessionList& list) {
  Rows rows{{"left out", "trial", "since", "reason"}};
  for (const LeftOut& one : list.left_out) {
    rows.push_back({one.participant, one.trial ? std::to_string(*one.trial) : "all",
                    moment(one.decided_utc), one.reason});
  }
  return rows.size() == 1 ? "" : "\n" + text_table(rows);
}

std::string note_table(const SessionList& list) {
  Rows rows{{"noted of", "protocol", "session", "what", "times", "the first"}};
  for (const Participation& one : list.participations) {
    for (const ListedSession& sitting : one.sittings) {
      for (const NoteSummary& note : sitting.notes) {
        rows.push_back({one.participant, one.protocol, std::to_string(sitting.session), note.kind,
                        std::to_string(note.count), or_none(note.first_text)});
      }
    }
  }
  return rows.size() == 1 ? "" : "\n" + text_table(rows);
}

json text_or_null(const std::string& text) { return text.empty() ? json() : json(text); }

json json_of(const ListedSession& sitting) {
  json notes = json::array();
  for (const NoteSummary& note : sitting.notes) {
    notes.push_back({{"kind", note.kind}, {"count", note.count}, {"first_text", note.first_text}});
  }
  return {{"session", sitting.session},
          {"started_utc", sitting.started_utc},
          {"ended_utc", text_or_null(sitting.ended_utc)},
          {"last_recorded_utc", sitting.last_recorded_utc},
          {"length_s", sitting.length_s},
          {"ending", text_or_null(sitting.ending)},
          {"running", sitting.running},
          {"resumed", sitting.resumed},
          {"resumed_at", text_or_null(sitting.resumed_at)},
          {"resumed_after_s", sitting.resumed_after_s},
          {"completed_trials", sitting.completed_trials},
          {"sync_tries", sitting.sync_tries},
          {"sync_passed", sitting.sync_passed},
          {"sync_overridden", sitting.sync_overridden},
          {"gaze_source", text_or_null(sitting.gaze_source)},
          {"browser", text_or_null(sitting.browser)},
          {"notes", std::move(notes)}};
}

json json_of(const Participation& one) {
  json sittings = json::array();
  for (const ListedSession& sitting : one.sittings) {
    sittings.push_back(json_of(sitting));
  }
  return {{"participant", one.participant},
          {"simulated", one.simulated},
          {"protocol", one.protocol},
          {"protocol_hash", one.protocol_hash},
          {"merged_from", text_or_null(one.merged_from)},
          {"group", text_or_null(one.group)},
          {"planned_utc", one.planned_utc},
          {"finished_utc", text_or_null(one.finished_utc)},
          {"planned_trials", one.planned_trials},
          {"completed_trials", one.completed_trials},
          {"practice_trials", one.practice_trials},
          {"interrupted_attempts", one.interrupted_attempts},
          {"set_aside_attempts", one.set_aside_attempts},
          {"timed_frames", one.timed_frames},
          {"late_timed_frames", one.late_timed_frames},
          {"sittings", std::move(sittings)}};
}

/// Tables of who takes part and how each sitting went, then what is left out and what notes say;
/// one sentence where nobody takes part. `name` is the study's.
std::string session_words(const std::string& name, const SessionList& list) {
  if (list.participations.empty()) {
    return printable(name) + ": nobody takes part yet; the study was made at " +
           moment(list.created_utc) + " UTC\n";
  }
  return title(name, list) + "\n" + participation_table(list) + "\n" + sitting_table(list) +
         left_out_table(list) + note_table(list);
}

/// The same as one JSON object; keys are the names of the structs' members.
std::string session_json(const std::string& name, const SessionList& list) {
  json participations = json::array();
  for (const Participation& one : list.participations) {
    participations.push_back(json_of(one));
  }
  json left_out = json::array();
  for (const LeftOut& one : list.left_out) {
    left_out.push_back({{"participant", one.participant},
                        {"trial", one.trial},
                        {"reason", one.reason},
                        {"decided_utc", one.decided_utc}});
  }
  const json whole = {{"study", name},
                      {"created_utc", list.created_utc},
                      {"build", list.build},
                      {"participations", std::move(participations)},
                      {"left_out", std::move(left_out)}};
  return whole.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

/// What `impetus sessions` was asked for.
struct SessionsOptions {
  std::string study;
  bool json{false};
};

/// Asked and let go before the study is opened: a session may begin while it is read.
bool is_in_use(const std::string& path) { return !ReadingLock(path).held(); }

int list_sessions(const SessionsOptions& options) {
  const bool in_use = is_in_use(options.study);
  StudyFile study = StudyFile::open_for_reading(options.study);
  return while_reading(study, [&] {
    const SessionList list = load_session_list(study, in_use);
    const std::string text =
        options.json ? session_json(study.name(), list) : session_words(study.name(), list);
    std::fputs(text.c_str(), stdout);
    return kDone;
  });
}

}  // namespace

void add_sessions(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<SessionsOptions>(
      app, chosen, list_sessions, "sessions",
      "List a study's participants, their progress and their sessions");
  command->add_option("study", options->study, "Study file; a session may be running on it")
      ->required();
  command->add_flag("--json", options->json, "As JSON");
}

}  // namespace impetus::inline commands
