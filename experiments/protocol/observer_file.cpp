// SPDX-License-Identifier: MIT
#include "experiments/protocol/observer_file.hpp"

#include <utility>

#include "experiments/models/file_place.hpp"

namespace impetus::inline protocol {
namespace {

std::filesystem::path find_observer(const std::string& name,
                                    const std::filesystem::path& protocol) {
  if (is_there(name)) {
    return name;
  }
  const auto root = std::filesystem::absolute(protocol).parent_path().parent_path();
  auto beside = root / "experiments" / "observers" / (name + ".json");
  if (!is_there(beside)) {
    throw InputError("--observer " + name + ": expected a file, or the name of one in " +
                     beside.parent_path().string());
  }
  return beside;
}

/// What an observer is made of besides its parameters.
struct Making {
  std::uint64_t seed;
  const std::string& pseudonym;
  VirtualClock& clock;
  const Clock& flip_clock;

  std::unique_ptr<RatingObserver> operator()(const CausalityParameters& parameters) const {
    return std::make_unique<CausalityObserver>(parameters, seed, pseudonym, clock);
  }
  std::unique_ptr<RatingObserver> operator()(const GapParameters& parameters) const {
    return std::make_unique<GapObserver>(parameters, seed, pseudonym, clock);
  }
  std::unique_ptr<RatingObserver> operator()(const GapThresholdParameters& parameters) const {
    return std::make_unique<GapObserver>(parameters, seed, pseudonym, clock, "gap-thresholds");
  }
  std::unique_ptr<RatingObserver> operator()(const ResponseParameters& parameters) const {
    return std::make_unique<ResponseObserver>(parameters, seed, pseudonym, clock);
  }
  std::unique_ptr<RatingObserver> operator()(const GazeObserverParameters& parameters) const {
    return std::make_unique<GazeObserver>(parameters, seed, pseudonym, clock, flip_clock);
  }
};

}  // namespace

std::size_t ObserverFile::points() const {
  return std::visit([](const auto& one) { return one.points(); }, parameters);
}

bool ObserverFile::clicks() const {
  return std::holds_alternative<GazeObserverParameters>(parameters);
}

bool ObserverFile::has_eye() const {
  return std::holds_alternative<GazeObserverParameters>(parameters);
}

ObserverFile load_observer(const std::string& name_or_path, const std::filesystem::path& protocol) {
  JsonDocument document = read_json(find_observer(name_or_path, protocol));
  ObserverParameters parameters = read_parameters(document);
  return {std::move(document), std::move(parameters)};
}

std::unique_ptr<RatingObserver> make_observer(const ObserverFile& file, std::uint64_t seed,
                                              const std::string& pseudonym, VirtualClock& clock,
                                              const Clock& flip_clock) {
  return std::visit(Making{seed, pseudonym, clock, flip_clock}, file.parameters);
}

}  // namespace impetus::inline protocol
