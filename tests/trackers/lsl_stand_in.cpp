// Stands in for liblsl where there is none: the few functions of its C interface that Impetus uses,
// as lsl_c.h declares them. A stream "gaze" sends sample n every 5 ms from when it is read, of four
// channels; the sender's clock is 1234.5 s ahead. What is pushed into an outlet is written to the
// file LSL_STAND_IN_LOG.
// SPDX-License-Identifier: MIT
#include <time.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

constexpr double kAhead_s = 1234.5;
constexpr double kStep_s = 0.005;

struct Stream {
  long next{0};
  char name[100]{};
  char type[100]{};
};

double now_s() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

void sleep_s(double wait_s) {
  const double whole_s = std::floor(wait_s);
  const timespec wait{static_cast<time_t>(whole_s), static_cast<long>((wait_s - whole_s) * 1e9)};
  nanosleep(&wait, nullptr);
}

}  // namespace

extern "C" {

void* lsl_create_streaminfo(const char* name, const char* type, std::int32_t channels, double hz,
                            std::int32_t format, const char* source) {
  if (channels != 1 || hz != 0.0 || format != 3 || std::strcmp(source, name) != 0) {
    return nullptr;
  }
  auto* info = new Stream;
  std::snprintf(info->name, sizeof info->name, "%s", name);
  std::snprintf(info->type, sizeof info->type, "%s", type);
  return info;
}

void lsl_destroy_streaminfo(void* info) { delete static_cast<Stream*>(info); }

std::int32_t lsl_get_channel_count(void* info) { return info == nullptr ? 0 : 4; }

std::int32_t lsl_resolve_byprop(void** found, std::uint32_t most, const char* property,
                                const char* value, std::int32_t least, double timeout_s) {
  if (most < 1 || least != 1 || timeout_s <= 0.0 || std::strcmp(property, "name") != 0 ||
      std::strcmp(value, "gaze") != 0) {
    return 0;
  }
  *found = new Stream;
  return 1;
}

void* lsl_create_inlet(void* info, std::int32_t buffer_s, std::int32_t chunk,
                       std::int32_t recover) {
  if (info == nullptr || buffer_s < 1 || chunk != 1 || recover != 1) {
    return nullptr;
  }
  auto* inlet = new Stream;
  inlet->next = static_cast<long>(now_s() / kStep_s) + 1;
  return inlet;
}

void lsl_destroy_inlet(void* inlet) { delete static_cast<Stream*>(inlet); }

double lsl_time_correction_ex(void* inlet, double* remote_s, double* uncertainty_s,
                              double timeout_s, std::int32_t* error) {
  *remote_s = now_s() + kAhead_s;
  *uncertainty_s = 0.0002;
  *error = inlet == nullptr || timeout_s < 0.0 ? -1 : 0;
  return -kAhead_s;
}

// x and y in shares from the upper left, which sample it is, and whether it is valid.
double lsl_pull_sample_d(void* given, double* values, std::int32_t count, double timeout_s,
                         std::int32_t* error) {
  auto* inlet = static_cast<Stream*>(given);
  const double due_s = static_cast<double>(inlet->next) * kStep_s;
  *error = count < 4 ? -1 : 0;
  const double wait_s = std::fmin(due_s - now_s(), timeout_s);
  if (wait_s > 0.0) {
    sleep_s(wait_s);
  }
  if (now_s() < due_s || *error != 0) {
    return 0.0;
  }
  const long n = inlet->next++;
  values[0] = n % 100 == 8 ? 1.25 : static_cast<double>(n % 200) / 200.0;
  values[1] = 1.0 - static_cast<double>(n / 200 % 200) / 200.0;
  values[2] = static_cast<double>(n);
  values[3] = n % 100 != 7 ? 1.0 : 0.0;
  return due_s + kAhead_s;
}

void* lsl_create_outlet(void* info, std::int32_t chunk, std::int32_t buffer_s) {
  return info == nullptr || chunk != 0 || buffer_s < 1 ? nullptr
                                                       : new Stream(*static_cast<Stream*>(info));
}

void lsl_destroy_outlet(void* outlet) { delete static_cast<Stream*>(outlet); }

std::int32_t lsl_push_sample_strtp(void* given, const char** data, double timestamp_s,
                                   std::int32_t pushthrough) {
  const auto* outlet = static_cast<const Stream*>(given);
  std::FILE* log = std::fopen(std::getenv("LSL_STAND_IN_LOG"), "a");
  if (log == nullptr || pushthrough != 1) {
    return -1;
  }
  std::fprintf(log, "%s %s %s %.9f\n", outlet->name, outlet->type, data[0], timestamp_s);
  std::fclose(log);
  return 0;
}

}  // extern "C"
