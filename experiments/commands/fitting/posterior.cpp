// SPDX-License-Identifier: MIT
#include "experiments/commands/fitting/posterior.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "experiments/commands/r_program.hpp"
#include "experiments/commands/scratch_folder.hpp"
#include "experiments/exports/r_scripts.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline commands {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr const char* kScript = "sample-posterior.R";
constexpr const char* kFolderBegin = "impetus-posterior-";
constexpr const char* kFailed = "--posterior: expected R to draw from it, got what it says above";

std::string line_of(const VectorXd& numbers) {
  std::ostringstream line;
  line.precision(17);
  for (Index i = 0; i < numbers.size(); ++i) {
    line << (i > 0 ? " " : "") << numbers[i];
  }
  return line.str();
}

VectorXd numbers_of(std::istringstream& words, std::size_t size) {
  VectorXd numbers(static_cast<Index>(size));
  std::string word;
  for (double& number : numbers) {
    if (!(words >> word)) {
      throw InputError(kFailed);
    }
    number = std::strtod(word.c_str(), nullptr);  // takes R's Inf, too
  }
  return numbers;
}

/// What the script says of one parameter: low, median, high, SD, Rhat, independent draws.
PosteriorParameter parameter_of(const PosteriorDensity& density, std::size_t at,
                                const VectorXd& told) {
  constexpr double kNormal = 1.959964;
  const double centre = density.prior_centre(at);
  const double sd = density.prior_sd(at);
  const double left = told[3] / sd;
  return {density.name(at),
          density.value(at, told[1]),
          density.value(at, told[0]),
          density.value(at, told[2]),
          density.value(at, centre - kNormal * sd),
          density.value(at, centre + kNormal * sd),
          std::max(0.0, 1.0 - left * left),
          told[4],
          told[5]};
}

/// A conversation with the script.
class Sampling {
 public:
  Sampling(PosteriorDensity& density, const std::function<void(double)>& progress)
      : density_(density),
        progress_(progress),
        script_({(write_r_scripts(folder_.path(), {kScript}) / kScript).string()}) {}

  Posterior run() {
    describe();
    while (const auto line = script_.hear()) {
      answer(*line);
    }
    if (script_.await() != 0 || posterior_.parameters.size() != density_.size()) {
      throw InputError(kFailed);
    }
    return std::move(posterior_);
  }

 private:
  void describe() {
    script_.tell(std::to_string(density_.size()));
    script_.tell(line_of(density_.mode()));
    for (Index row = 0; row < density_.covariance().rows(); ++row) {
      script_.tell(line_of(density_.covariance().row(row)));
    }
  }

  void answer(const std::string& line) {
    std::istringstream words(line);
    std::string what;
    words >> what;
    if (what == "density") {
      script_.tell(
          line_of(VectorXd::Constant(1, density_.logarithm(numbers_of(words, density_.size())))));
    } else if (what == "progress") {
      progress_(numbers_of(words, 1)[0]);
    } else if (what == "parameter") {
      posterior_.parameters.push_back(
          parameter_of(density_, posterior_.parameters.size(), numbers_of(words, 6)));
    } else if (what == "draw") {
      std::vector<double>& draw = posterior_.draws.emplace_back();
      draw.push_back(numbers_of(words, 1)[0]);
      const VectorXd x = numbers_of(words, density_.size());
      for (std::size_t i = 0; i < density_.size(); ++i) {
        draw.push_back(density_.value(i, x[static_cast<Index>(i)]));
      }
    }
  }

  PosteriorDensity& density_;
  const std::function<void(double)>& progress_;
  ScratchFolder folder_{own_disk(), kFolderBegin};
  AskingRScript script_;
  Posterior posterior_;
};

}  // namespace

bool Posterior::agrees() const {
  constexpr double kLargestRhat = 1.01;
  constexpr double kEnough = 400.0;
  return std::all_of(parameters.begin(), parameters.end(), [](const PosteriorParameter& one) {
    return one.rhat <= kLargestRhat && one.enough >= kEnough;
  });
}

void require_sampler() {
  const ScratchFolder folder(own_disk(), kFolderBegin);
  if (run_needed_r_script(
          {(write_r_scripts(folder.path(), {kScript}) / kScript).string(), "--check"}) != 0) {
    throw InputError(kFailed);
  }
}

Posterior sample_posterior(PosteriorDensity& density, const std::function<void(double)>& progress) {
  return Sampling(density, progress).run();
}

std::string draws_table(const Posterior& posterior) {
  constexpr int kWritten = 6;
  std::string text = "chain";
  for (const PosteriorParameter& one : posterior.parameters) {
    text += "," + one.name;
  }
  for (const std::vector<double>& draw : posterior.draws) {
    for (std::size_t i = 0; i < draw.size(); ++i) {
      text += (i == 0 ? "\n" : ",") + rounded_number(draw[i], kWritten);
    }
  }
  return text + "\n";
}

}  // namespace impetus::inline commands
