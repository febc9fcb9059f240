// SPDX-License-Identifier: MIT
#include "experiments/markers/marker_writer.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace impetus::inline markers {
namespace {

constexpr std::chrono::milliseconds kLongestWait{100};

}  // namespace

MarkerWriter::MarkerWriter(std::unique_ptr<MarkerLine> line, MarkerCodes codes, const Clock& clock)
    : line_(std::move(line)),
      codes_(std::move(codes)),
      clock_(clock),
      thread_([this] { send_until_the_end(); }) {}

MarkerWriter::~MarkerWriter() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  told_.notify_one();
  thread_.join();
}

void MarkerWriter::mark(MarkedEvent event, std::int64_t event_ns, std::int64_t interval) {
  const std::optional<std::int64_t> code = codes_.of(event);
  if (!code) {
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    records_.push_back({event, *code, event_ns, std::nullopt, interval});
    waiting_.push_back(records_.back());
  }
  told_.notify_one();
}

std::vector<MarkerRecord> MarkerWriter::take() {
  std::unique_lock lock(mutex_);
  sent_.wait_for(lock, kLongestWait, [this] { return waiting_.empty(); });
  counts_.marked += records_.size();
  counts_.lost += static_cast<std::size_t>(std::count_if(
      records_.begin(), records_.end(), [](const MarkerRecord& one) { return !one.written_ns; }));
  return std::exchange(records_, {});
}

void MarkerWriter::send_until_the_end() {
  std::unique_lock lock(mutex_);
  for (;;) {
    told_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
    if (waiting_.empty()) {
      return;
    }
    const MarkerRecord next = waiting_.front();
    lock.unlock();
    const bool is_sent = line_->write(next.event, next.code, next.event_ns);
    const std::int64_t now_ns = clock_.now_ns();
    lock.lock();
    waiting_.pop_front();
    if (is_sent && sent_count_ >= counts_.marked) {
      records_[sent_count_ - counts_.marked].written_ns = now_ns;
    }
    ++sent_count_;
    sent_.notify_one();
  }
}

}  // namespace impetus::inline markers
