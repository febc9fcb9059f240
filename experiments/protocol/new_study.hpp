// A study of one's own, made of a template and a few choices: protocol, scene and simulated
// participant, as JSON.
//
//   protocols/templates/two-balls.json   what is shown, and what of it can be varied
//   protocols/templates/study.json       what is asked, and all that every study says;
//   study.de.json
//                                        its words in another language
//        + choices ─> protocol.json, scene.json, observer.json, and what the scene names
//
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline protocol {

/// A scene to begin with, and the factors that it offers.
struct StudyTemplate {
  std::string name;
  std::string words;                 ///< what is shown
  std::vector<std::string> offered;  ///< factors, the one of interest first
};

/// All templates, the plainest first.
std::vector<StudyTemplate> study_templates();

/// What can be asked of each trial.
struct OfferedQuestion {
  std::string name;     ///< that choices have
  std::string words;    ///< "": there are none
  bool detects{false};  ///< answers become right as levels rise
};

/// All that can be asked about a template's scene, in the words of a language. Throws InputError.
std::vector<OfferedQuestion> offered_questions(const std::string& study_template,
                                               const std::string& language = "en");

/// What somebody chose.
struct StudyChoices {
  std::string name;  ///< of the protocol
  std::string study_template;
  /// "restitution=0.2,0.5,0.8"; a name alone has the template's levels; a JSON Pointer into the
  /// scene in place of a name varies anything else.
  std::vector<std::string> vary;
  std::string ask;
  std::string question;        ///< its words; "": the template's
  std::string language{"en"};  ///< one that comes with the program, or a file's name
  /// "all": each is shown equally often. "staircase", "quest": those of the first factor are chosen
  /// trial by trial.
  std::string levels{"all"};
};

/// The texts of the study's files, by name, whose simulated participant goes by the first factor.
/// Throws InputError where a choice is not offered or not understood; whether the study is valid,
/// the protocol's own checks say.
std::map<std::string, std::string> make_study(const StudyChoices& choices);

}  // namespace impetus::inline protocol
