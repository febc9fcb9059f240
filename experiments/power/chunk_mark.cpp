// SPDX-License-Identifier: MIT
#include "experiments/power/chunk_mark.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <nlohmann/json.hpp>

#include "experiments/models/atomic_file.hpp"
#include "experiments/power/chunk_file.hpp"
#include "experiments/power/process_mark.hpp"
#include "experiments/settings/json_document.hpp"

namespace impetus::inline power {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::chrono::seconds kFreshEvery{10};
constexpr double kSilentAfter_s = 120.0;  ///< machines' clocks may differ by some of it
constexpr const char* kRunning = ".running.json";
constexpr const char* kFailed = ".failed.json";

double now_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::string name_of_this_machine() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "unknown";
}

/// Whoever cannot write a mark goes on without one.
void write_mark(const fs::path& file, const json& mark) {
  try {
    write_whole_file(file, mark.dump(-1, ' ', false, json::error_handler_t::replace) + "\n");
  } catch (const std::exception&) {
  }
}

/// Null where there is none, or where it says nothing.
json read_mark(const fs::path& file) {
  try {
    return fs::exists(file) ? read_json(file).value : json();
  } catch (const std::exception&) {
    return {};
  }
}

void remove_mark(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
}

/// Whether the process of a mark has ended, as far as this machine can know.
bool has_ended(const json& mark) {
  return mark.value("machine", "") == name_of_this_machine() &&
         !still_runs(mark.value("process", ""));
}

void read_running(const json& mark, ChunkReport& report) {
  const double silent_s = std::max(0.0, now_s() - mark.value("told_s", 0.0));
  report.state =
      silent_s > kSilentAfter_s || has_ended(mark) ? ChunkState::kSilent : ChunkState::kRunning;
  report.machine = mark.value("machine", "");
  report.share = std::clamp(mark.value("share", 0.0), 0.0, 1.0);
  report.since_s = report.state == ChunkState::kSilent
                       ? silent_s
                       : std::max(0.0, now_s() - mark.value("began_s", now_s()));
}

void read_failed(const json& mark, ChunkReport& report) {
  report.state = ChunkState::kFailed;
  report.machine = mark.value("machine", "");
  report.sentence = mark.value("sentence", "");
  report.since_s = std::max(0.0, now_s() - mark.value("failed_s", now_s()));
}

}  // namespace

ChunkMark::ChunkMark(const fs::path& out, std::int64_t number)
    : out_(out), number_(number), machine_(name_of_this_machine()), began_s_(now_s()) {
  remove_mark(chunk_file(out_, number_, kFailed));
  write();
  thread_ = std::thread([this] { keep_fresh(); });
}

ChunkMark::~ChunkMark() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  told_.notify_one();
  thread_.join();
  remove_mark(chunk_file(out_, number_, kRunning));
}

void ChunkMark::tell(double share) {
  const std::lock_guard lock(mutex_);
  share_ = share;
}

void ChunkMark::fail(const std::string& sentence) const {
  write_mark(chunk_file(out_, number_, kFailed),
             {{"machine", machine_}, {"failed_s", now_s()}, {"sentence", sentence}});
}

void ChunkMark::keep_fresh() {
  std::unique_lock lock(mutex_);
  while (!told_.wait_for(lock, kFreshEvery, [this] { return ends_; })) {
    write();
  }
}

void ChunkMark::write() const {
  write_mark(chunk_file(out_, number_, kRunning), {{"machine", machine_},
                                                   {"process", mark_of_this_process()},
                                                   {"began_s", began_s_},
                                                   {"told_s", now_s()},
                                                   {"share", share_}});
}

ChunkReport report_of_chunk(const fs::path& out, std::int64_t number) {
  ChunkReport report;
  report.number = number;
  if (fs::exists(chunk_file(out, number))) {
    report.state = ChunkState::kDone;
    return report;
  }
  try {
    if (const json running = read_mark(chunk_file(out, number, kRunning)); running.is_object()) {
      read_running(running, report);
    } else if (const json failed = read_mark(chunk_file(out, number, kFailed));
               failed.is_object()) {
      read_failed(failed, report);
    }
  } catch (const json::exception&) {  // a mark of other words says nothing
  }
  return report;
}

SweepSums sums_of(const std::vector<ChunkReport>& reports, double chunk_s) {
  SweepSums sums;
  double left = 0.0;  // in chunks
  for (const ChunkReport& report : reports) {
    switch (report.state) {
      case ChunkState::kWaiting:
        ++sums.waiting;
        break;
      case ChunkState::kRunning:
        ++sums.running;
        break;
      case ChunkState::kSilent:
        ++sums.silent;
        break;
      case ChunkState::kFailed:
        ++sums.failed;
        break;
      case ChunkState::kDone:
        ++sums.done;
        continue;
    }
    left += report.state == ChunkState::kRunning ? 1.0 - report.share : 1.0;
  }
  sums.left_s = chunk_s * left / static_cast<double>(std::max<std::int64_t>(sums.running, 1));
  return sums;
}

}  // namespace impetus::inline power
