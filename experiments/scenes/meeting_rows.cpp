// SPDX-License-Identifier: MIT
#include "experiments/scenes/meeting_rows.hpp"

namespace impetus::inline scenes {
namespace {

Kind<RandomSpin> random_spin_kind() {
  using R = RandomSpin;
  using L = SpinLimits;
  const Kind<L> limits =
      defined("spin_limits", object<L>("Radians per second about the world's axes.",
                                       {required("least_rad_s", &L::least_rad_s, vector_kind()),
                                        required("most_rad_s", &L::most_rad_s, vector_kind())}));
  return object<R>(
      "Of two bodies that meet at one level: a random change of angular velocity at their "
      "collision, each component uniform between two limits; drawn with each trial's seed, and "
      "logged.",
      {required("on", &R::on, flag(), "false: nothing is added."),
       required("at_level", &R::at_level, level_kind(),
                "Only collisions handled at this level get it."),
       required("a", &R::a, limits, "Of the first body."),
       required("b", &R::b, limits, "Of the second body.")});
}

Kind<ReboundSettings> rebound_kind() {
  using R = ReboundSettings;
  using C = R::Change;
  static const Names<C> changes{{"wider", C::kWider},
                                {"narrower", C::kNarrower},
                                {"faster", C::kFaster},
                                {"slower", C::kSlower}};
  return object<R>(
      "Of two bodies that meet: how they part for the first time is changed (O'Sullivan, "
      "Dingliana, "
      "Giang and Kaiser 2003).",
      {required("change", &R::change, choice(changes),
                "wider, narrower: the angle on the screen between their ways, half of it each; "
                "faster, slower: both speeds."),
       required("amount", &R::amount, number({0, 180}),
                "Degrees of wider and narrower; percent of faster and, 100 at most, slower.")});
}

}  // namespace

Kind<Vector3> vector_kind() {
  return defined("vector", vector({-10000, 10000}), "Right, up, towards the viewer at azimuth 0.");
}

Kind<MeetingSettings> meeting_kind() {
  using M = MeetingSettings;
  return object<M>(
      "The two bodies approach along x, each at this speed, and touch at the centre after lead_s.",
      {required("speed_deg_s", &M::speed_deg_s, number(above(0, 1000))),
       row("speed_percent", &M::speed_percent, number(above(0, 1000)),
           "Scales speed_deg_s; 100 when left out."),
       row("offset_deg", &M::offset_deg, several<2>(number({-45, 45})),
           "Up and towards the viewer at azimuth 0: how far the second body's line of approach "
           "lies from the first's; both lie about the meeting point. 0 and 0 when left out."),
       row("at_deg", &M::at_deg,
           screen_place_kind("Where on the screen they meet; its centre when left out.")),
       row("gap_arcmin", &M::gap_arcmin, number({0, 600}),
           "Of two spheres: they meet an invisible shell, and turn back with a gap between the "
           "drawn surfaces that the viewer sees under this angle. 0 when left out."),
       row("second_rests", &M::second_rests, flag(),
           "true: the second body waits where they meet, and the first alone approaches. false "
           "when left out."),
       required("lead_s", &M::lead_s, number(above(0, 60)),
                "From onset to contact: a whole number of steps and of frames."),
       required("follow_s", &M::follow_s, number(above(0, 60)),
                "From release to the end of the stimulus.")});
}

Kind<DistractorSettings> distractors_kind() {
  using D = DistractorSettings;
  return object<D>(
      "Beside two bodies that meet: others like them, that move straight on at their speed in the "
      "plane of the screen and touch nothing; where, is drawn with each trial's seed.",
      {required("count", &D::count, whole<std::size_t>({0, 100})),
       required("apart_deg", &D::apart_deg, number(above(0, 45)),
                "At least between any two surfaces, as they are drawn, at any time."),
       required("within_deg", &D::within_deg, several<2>(number(above(0, 90))),
                "Their centres stay so far from the screen's centre, at most, to the sides and up "
                "and down.")});
}

Kind<ImposedSettings> imposed_kind() {
  using I = ImposedSettings;
  return object<I>(
      "Manipulations that are not physics; recorded as such with each collision.",
      {row("contact_hold_ms", &I::contact_hold_ms, number({0, 60000}),
           "Both bodies freeze where they touch for this long, or where a launch has them: a whole "
           "number of frames."),
       row("random_spin", &I::random_spin, random_spin_kind()),
       row("rebound", &I::rebound, rebound_kind()),
       row("gaze_latency_ms", &I::gaze_latency_ms, number({0, 10000}),
           "Samples of the gaze younger than this are not used yet; added to the protocol's "
           "extra_latency_ms."),
       row("no_spin", &I::no_spin, flag(),
           "Inverse inertia zero: contacts off the centre turn no body.")});
}

}  // namespace impetus::inline scenes
