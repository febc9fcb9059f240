// SPDX-License-Identifier: MIT
#include "experiments/connections/lsl.hpp"

#include <cstdlib>

#include "experiments/connections/loaded_library.hpp"
#include "experiments/connections/tcp.hpp"

namespace impetus::inline connections {
namespace {

// As lsl_c.h has them.
constexpr std::int32_t kText = 3;
constexpr std::int32_t kBuffer_s = 10;
constexpr double kIrregular_hz = 0.0;

/// The functions that are used.
struct LslLibrary {
  void* (*new_info)(const char*, const char*, std::int32_t, double, std::int32_t, const char*);
  void (*end_info)(void*);
  std::int32_t (*channels)(void*);
  std::int32_t (*resolve)(void**, std::uint32_t, const char*, const char*, std::int32_t, double);
  void* (*new_inlet)(void*, std::int32_t, std::int32_t, std::int32_t);
  void (*end_inlet)(void*);
  double (*pull)(void*, double*, std::int32_t, double, std::int32_t*);
  double (*correction)(void*, double*, double*, double, std::int32_t*);
  void* (*new_outlet)(void*, std::int32_t, std::int32_t);
  void (*end_outlet)(void*);
  std::int32_t (*push)(void*, const char**, double, std::int32_t);
};

/// PYLSL_LIB first, by which pylsl is told where it is.
std::vector<std::string> library_names() {
  std::vector<std::string> names;
  if (const char* chosen = std::getenv("PYLSL_LIB"); chosen != nullptr && *chosen != '\0') {
    names.emplace_back(chosen);
  }
  names.insert(names.end(), {"liblsl.so", "liblsl.so.2", "liblsl64.so"});
  return names;
}

LslLibrary load_library() {
  const LoadedLibrary library(library_names());
  LslLibrary lsl{};
  library.find("lsl_create_streaminfo", lsl.new_info);
  library.find("lsl_destroy_streaminfo", lsl.end_info);
  library.find("lsl_get_channel_count", lsl.channels);
  library.find("lsl_resolve_byprop", lsl.resolve);
  library.find("lsl_create_inlet", lsl.new_inlet);
  library.find("lsl_destroy_inlet", lsl.end_inlet);
  library.find("lsl_pull_sample_d", lsl.pull);
  library.find("lsl_time_correction_ex", lsl.correction);
  library.find("lsl_create_outlet", lsl.new_outlet);
  library.find("lsl_destroy_outlet", lsl.end_outlet);
  library.find("lsl_push_sample_strtp", lsl.push);
  return lsl;
}

const LslLibrary& lsl() {
  static const LslLibrary library = load_library();
  return library;
}

using StreamInfo = std::unique_ptr<void, void (*)(void*)>;

}  // namespace

LslInlet::LslInlet(const std::string& name, double longest_s) : inlet_(nullptr, lsl().end_inlet) {
  void* found = nullptr;
  if (lsl().resolve(&found, 1, "name", name.c_str(), 1, longest_s) < 1 || found == nullptr) {
    throw NotConnected("no stream of that name");
  }
  const StreamInfo info(found, lsl().end_info);
  channels_ = static_cast<std::size_t>(lsl().channels(info.get()));
  // One sample at a time, and found again by itself where its sender comes back.
  inlet_.reset(lsl().new_inlet(info.get(), kBuffer_s, 1, 1));
  if (!inlet_) {
    throw NotConnected("its stream cannot be read");
  }
}

std::optional<LslInlet::Sample> LslInlet::pull(double longest_s) {
  Sample sample;
  sample.values.resize(channels_);
  std::int32_t error = 0;
  sample.remote_s = lsl().pull(inlet_.get(), sample.values.data(),
                               static_cast<std::int32_t>(channels_), longest_s, &error);
  if (error != 0) {
    throw NotConnected("the stream was lost");
  }
  return sample.remote_s == 0.0 ? std::nullopt : std::optional(std::move(sample));
}

LslInlet::Correction LslInlet::correction(double longest_s) {
  Correction correction;
  double remote_s = 0.0;
  std::int32_t error = 0;
  correction.offset_s =
      lsl().correction(inlet_.get(), &remote_s, &correction.uncertainty_s, longest_s, &error);
  if (error != 0) {
    throw NotConnected("the sender's clock does not answer");
  }
  return correction;
}

LslOutlet::LslOutlet(const std::string& name, const std::string& type)
    : outlet_(nullptr, lsl().end_outlet) {
  const StreamInfo info(
      lsl().new_info(name.c_str(), type.c_str(), 1, kIrregular_hz, kText, name.c_str()),
      lsl().end_info);
  outlet_.reset(info ? lsl().new_outlet(info.get(), 0, kBuffer_s) : nullptr);
  if (!outlet_) {
    throw NotConnected("no stream could be made");
  }
}

bool LslOutlet::push(const std::string& text, std::int64_t at_ns) {
  const char* data = text.c_str();
  return lsl().push(outlet_.get(), &data, static_cast<double>(at_ns) * 1e-9, 1) == 0;
}

}  // namespace impetus::inline connections
