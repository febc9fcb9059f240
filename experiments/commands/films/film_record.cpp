// SPDX-License-Identifier: MIT
#include "experiments/commands/films/film_record.hpp"

#include <array>
#include <utility>

#include "experiments/drawing/picture_map.hpp"
#include "experiments/record/wall_names.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline commands {
namespace {

using nlohmann::ordered_json;

constexpr std::array<std::uint32_t, 256> crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
    std::uint32_t value = byte;
    for (int bit = 0; bit < 8; ++bit) {
      value = (value >> 1U) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    table[byte] = value;
  }
  return table;
}

constexpr std::array<std::uint32_t, 256> kCrcTable = crc_table();

std::string hex(std::uint32_t value) { return printed("%08x", value); }

ordered_json to_list(const Vector3& vector) { return {vector.x(), vector.y(), vector.z()}; }

const char* showing(const PaintedFrame& frame) {
  return frame.kind == FilmFrame::Kind::kBetween          ? "blank"
         : frame.recorded->phase == FramePhase::kFixation ? "fixation"
                                                          : "stimulus";
}

std::string body_name(const StagedScene& scene, std::int32_t body) {
  return is_wall(body) ? wall_name(body, wall_naming(scene.world.settings().enclosure))
                       : scene.world.models()[static_cast<std::size_t>(body)].name;
}

ordered_json contact_row(const StagedScene& scene, const FilmedContact& contact) {
  const CollisionReport& report = contact.report;
  ordered_json row{
      {"bodies", {body_name(scene, report.bodies.a), body_name(scene, report.bodies.b)}},
      {"step", contact.step},
      {"begins", report.began},
      {"level", report.level},
      {"finest", report.stop == StopReason::kFinest},
      {"impulse_Ns", report.impulse_Ns},
      {"points_m", ordered_json::array()}};
  for (const TouchPoint& touch : contact.touches) {
    row["points_m"].push_back(to_list(touch.point));
  }
  if (contact.truth) {
    row["gap_m"] = contact.truth->gap_m;
    row["gap_arcmin"] = contact.truth->gap_arcmin;
    row["gap_hidden_share"] = contact.truth->hidden_share;
  }
  return row;
}

}  // namespace

std::uint32_t crc32_of(const Pixels& picture) {
  std::uint32_t crc = ~0U;
  for (const std::uint8_t byte : picture.rgb) {
    crc = (crc >> 8U) ^ kCrcTable[(crc ^ byte) & 0xFFU];
  }
  return ~crc;
}

FilmRecord::FilmRecord(ordered_json head, const PictureSize& size, double frames_per_second,
                       bool was_flipped)
    : head_(std::move(head)),
      size_(size),
      frames_per_second_(frames_per_second),
      was_flipped_(was_flipped) {
  head_["width_px"] = size.width_px;
  head_["height_px"] = size.height_px;
  head_["frames_per_second"] = frames_per_second;
}

void FilmRecord::add(const PaintedFrame& frame) {
  const FrameRecord& recorded = *frame.recorded;
  const double film_s = static_cast<double>(sums_.frames) / frames_per_second_;
  ordered_json row{{"frame", sums_.frames}, {"film_s", film_s}, {"showing", showing(frame)}};
  if (was_flipped_) {
    const bool is_new = frame.kind == FilmFrame::Kind::kShown;
    row["interval"] = recorded.interval;
    row["recorded_frame"] = is_new ? ordered_json(recorded.frame) : ordered_json();
    row["flipped_ns"] = is_new ? ordered_json(recorded.flip.flipped_ns) : ordered_json();
    row["held"] = frame.kind == FilmFrame::Kind::kHeld;
  }
  row["crc32"] = hex(frame.crc32);
  if (frame.run != nullptr) {
    row["stimulus_s"] = recorded.shown_time_s;
    row["step"] = frame.run->step();
    add_bodies(frame, row);
    add_contacts(frame, row);
  }
  rows_ += (rows_.empty() ? "" : ",\n") + row.dump();
  ++sums_.frames;
  sums_.seconds = static_cast<double>(sums_.frames) / frames_per_second_;
}

void FilmRecord::add_bodies(const PaintedFrame& frame, ordered_json& row) const {
  const Picture picture = frame.run->picture(frame.recorded->shown_time_s);
  const PictureMap map(picture.viewer, {0, 0, size_.width_px, size_.height_px}, size_.height_px);
  row["bodies"] = ordered_json::array();
  for (const PosedBody& body : picture.bodies) {
    const Quaternion& turn = body.pose.orientation;
    const auto seen = map.seen(body.pose.position);
    row["bodies"].push_back(
        {{"name", body.look.name},
         {"position_m", to_list(body.pose.position)},
         {"orientation_wxyz", {turn.w(), turn.x(), turn.y(), turn.z()}},
         {"centre_px", seen ? ordered_json{seen->x, seen->y} : ordered_json()}});
  }
}

/// What the frame's own steps brought: a frame that is held brings nothing.
void FilmRecord::add_contacts(const PaintedFrame& frame, ordered_json& row) {
  row["contacts"] = ordered_json::array();
  if (frame.kind != FilmFrame::Kind::kShown) {
    return;
  }
  for (const FilmedContact& contact : frame.run->contacts()) {
    row["contacts"].push_back(contact_row(frame.run->scene(), contact));
    count(contact);
  }
}

void FilmRecord::count(const FilmedContact& contact) {
  if (!sums_.contact_frame) {
    sums_.contact_frame = sums_.frames;
    sums_.contact_s = static_cast<double>(sums_.frames) / frames_per_second_;
    sums_.level = contact.report.level;
    sums_.gap_arcmin = contact.truth ? std::optional(contact.truth->gap_arcmin) : std::nullopt;
  }
  sums_.collisions += contact.report.began ? 1 : 0;
}

std::string FilmRecord::text() const {
  std::string text = "{\n";
  for (const auto& [key, value] : head_.items()) {
    text += ordered_json(key).dump() + ": " + value.dump() + ",\n";
  }
  const ordered_json first =
      sums_.contact_frame ? ordered_json(*sums_.contact_frame) : ordered_json();
  return text + "\"contact_frame\": " + first.dump() + ",\n\"frames\": [\n" + rows_ + "\n]\n}\n";
}

}  // namespace impetus::inline commands
