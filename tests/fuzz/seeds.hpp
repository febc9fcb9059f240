// The seeds of the fuzzers, made by code: small files of every format and of every kind of tree.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/models/mesh_bytes.hpp"
#include "tests/experiments/site/page_session.hpp"
#include "tests/experiments/stored_trees.hpp"
#include "tests/fuzz/small_studies.hpp"
#include "tests/fuzz/targets.hpp"

namespace impetus {

/// As fuzz_mesh_file() takes them.
inline std::vector<std::string> mesh_seeds() {
  const std::string corners = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const std::string faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const std::string binary_stl = [] {
    std::string text(80, ' ');
    append_number(text, std::uint32_t{1});
    for (const float number : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) {
      append_number(text, number);
    }
    return text + std::string(2, '\0');
  }();
  return {std::string("\0", 1) +
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
          std::string("\0", 1) +
              "o a\nv 0 0 0 1\nvt 0 0\nvn 0 0 1\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1/1 2/1/1 -2 -1\n",
          "\1ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
          "float "
          "z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n" +
              corners + faces,
          "\2solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
          "0\nendloop\nendfacet\nendsolid a\n",
          "\2" + binary_stl,
          "\3OFF\n4 4 6\n" + corners + faces,
          "\4{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{"
          "\"mesh\":0}],"
          "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"accessors\":[{"
          "\"bufferView\":0,"
          "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"bufferViews\":[{\"buffer\":0,"
          "\"byteLength\":"
          "36}],\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/octet-stream;base64,"
          "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\"}]}"};
}

/// As fuzz_tree_file() takes them.
inline std::vector<std::string> tree_seeds() {
  constexpr std::size_t kChecksumLetters = 32;
  RandomStream random(1, "seeds");
  std::vector<std::string> seeds;
  for (StoredTree& stored : all_stored(random)) {
    seeds.push_back(bytes_of(stored));
    seeds.back().resize(seeds.back().size() - kChecksumLetters);
  }
  return seeds;
}

/// As fuzz_protocol() takes them.
inline std::vector<std::string> protocol_seeds() { return small_protocols(); }

/// As fuzz_scene() takes them.
inline std::vector<std::string> scene_seeds() {
  std::vector<std::string> seeds;
  for (const std::string& texts : small_protocols()) {
    seeds.push_back(texts.substr(texts.find(kPartSeparator) + 1));
  }
  return seeds;
}

/// As fuzz_lines() takes them: a session to the end of its second trial.
inline std::vector<std::string> lines_seeds() {
  std::string text;
  int attempts = 0;
  for (const std::string& line : lines_from(small_published_study(), {})) {
    text += line + "\n";
    attempts += nlohmann::json::parse(line)["kind"] == "attempt" ? 1 : 0;
    if (attempts == 2) {
      break;
    }
  }
  return {text};
}

/// As fuzz_tracker() takes them.
inline std::vector<std::string> tracker_seeds() {
  const std::vector<std::uint8_t> message = nlohmann::json::to_msgpack(
      {{"name", "screen"},
       {"gaze_on_surfaces",
        {{{"timestamp", 12.5}, {"norm_pos", {0.25, 0.75}}, {"confidence", 0.99}, {"on_surf", true}},
         {{"timestamp", 12.505}, {"norm_pos", {1.5, 0.5}}, {"confidence", 1}, {"on_surf", false}},
         {{"timestamp", 12.51}, {"norm_pos", nullptr}, {"confidence", 0.1}}}}});
  return {std::string(1, static_cast<char>(kPupilMessage)) +
              std::string(message.begin(), message.end()),
          "\x11<ACK ID=\"ENABLE_SEND_DATA\" STATE=\"1\" />\r\n"
          "<REC TIME=\"12.345\" FPOGX=\"0.1\" FPOGY=\"0.2\" FPOGV=\"1\" BPOGX=\"0.3\" "
          "BPOGY=\"0.4\" BPOGV=\"1\" />\r\n<CAL ID=\"CALIB_START_PT\" PT=\"1\" />\r\n"
          "<REC TIME=\"12.350\" FPOGX=\"1e9\" FPOGY=\"nan\" FPOGV=\"1\" />\r\n"};
}

/// As fuzz_study() takes them: changes of values that a replay reads, and a whole file.
inline std::vector<std::string> study_seeds() {
  std::vector<std::string> seeds;
  for (std::size_t base = 0; base < small_studies().size(); ++base) {
    for (const char* change :
         {"UPDATE trial SET condition='{\"delay_ms\":1e300}'", "UPDATE trial SET solved='[1]'",
          "UPDATE session SET refresh_hz=-1,screen_width_px=0,recording_format=99",
          "UPDATE session SET viewing_distance_m=0", "UPDATE step SET digests=x'00',hash=1",
          "UPDATE step SET work_granted=-9223372036854775808,region_x_m=1e300",
          "UPDATE protocol SET scene_json='{}'", "UPDATE protocol SET protocol_json='['",
          "UPDATE gaze SET loss='a'", "UPDATE gaze SET x_m=1e308,y_m=NULL,taken_ns=-1",
          "UPDATE click SET device='',arrived_ns=-9223372036854775808,interval=9",
          "UPDATE attempt SET trial_id=1;DELETE FROM protocol"}) {
      seeds.push_back(std::string(1, static_cast<char>(base)) + change);
    }
  }
  seeds.push_back(kWholeFile + small_studies().front());
  return seeds;
}

}  // namespace impetus
