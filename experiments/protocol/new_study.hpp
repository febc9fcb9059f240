// A study of one's own, made of a template and a few choices: protocol, scene and simulated
// participant, as JSON.
//
//   protocols/templates/two-balls.json   what is shown, and what of it can be varied
//   protocols/templates/study.json       what is asked, and all that every study says;
//   study.de.json
//                                        its words in another language
//        + choices ─> protocol.json, scene.json, observer.json
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

/// What can be asked of each trial, by the names that choices have, with the question's words in a
/// language; "": there are none.
std::vector<std::pair<std::string, std::string>> offered_questions(
    const std::string& language = "en");

/// What somebody chose.
struct StudyChoices {
  std::string name;  ///< of the protocol
  std::string study_template;
  /// "restitution=0.2,0.5,0.8"; a name alone has the template's levels; a JSON Pointer into the
  /// scene in place of a name varies anything else.
  std::vector<std::string> vary;
  std::string ask;
  std::string question;
  std::string language{"en"};  ///< one that comes with the program, or a file's name
};

/// The files of the study, by name, whose simulated participant goes by the first factor. Throws
/// InputError where a choice is not offered or not understood; whether the study is valid, the
/// protocol's own checks say.
std::map<std::string, OrderedJson> make_study(const StudyChoices& choices);

}  // namespace impetus::inline protocol
