// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "evaluate_features/Command.h"
#include "evaluate_features/Correspondence.h"
#include "evaluate_features/Feature_file.h"
#include "options/Length.h"

#include <CGAL/Animated_mesh_features/Evaluation/Placed_feature.h>
#include <CGAL/Animated_mesh_features/Evaluation/bootstrap_interval.h>
#include <CGAL/Animated_mesh_features/Evaluation/chance_level.h>
#include <CGAL/Animated_mesh_features/Evaluation/paired_features.h>
#include <CGAL/Animated_mesh_features/Evaluation/repeated_features.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <Eigen/Core>

#include <algorithm>

namespace AMF = CGAL::Animated_mesh_features;
using Programs::Argument;
using Programs::Option_group;
using Programs::Option_groups;

namespace Evaluate_features {

namespace {

typedef std::vector<AMF::Placed_feature> Placed_features;

// The features of two files on the shape of B.
struct Placed_pair
{
  Placed_features a, b;
  Points points_of_b; // none without a mesh
  double diagonal_a = 0, diagonal_b = 0;
  double frame_duration = 0, period = 0; // of the coarser frames; of the longer animation
};

Placed_features placed(const std::vector<Feature_point>& features)
{
  Placed_features result;
  for (const Feature_point& f : features)
    result.push_back(
        {AMF::Rest_shape::Point(f.rest_position[0], f.rest_position[1], f.rest_position[2]), f.time, f.sigma, f.tau});
  return result;
}

Placed_pair placed_pair(const Pair_options& o, const Feature_file& a, const Feature_file& b)
{
  Placed_pair pair;
  pair.a = placed(a.features());
  pair.b = placed(b.features());
  pair.diagonal_a = a.data.description.bounding_box_diagonal;
  pair.diagonal_b = b.data.description.bounding_box_diagonal;
  if (!o.rest_b.empty()) {
    pair.points_of_b = read_points(o.rest_b, b);
    pair.diagonal_b = diagonal(pair.points_of_b);
    const std::vector<std::size_t> vertices = corresponding_vertices(o, a, b, pair.points_of_b);
    for (std::size_t i = 0; i < pair.a.size(); ++i) pair.a[i].place = pair.points_of_b[vertices[i]];
    for (std::size_t i = 0; i < pair.b.size(); ++i) pair.b[i].place = pair.points_of_b[b.features()[i].vertex_index];
  }
  if (!o.rest_a.empty()) pair.diagonal_a = diagonal(read_points(o.rest_a, a));
  pair.frame_duration = (std::max)(a.frame_duration(), b.frame_duration());
  pair.period = (std::max)(a.duration(), b.duration());
  return pair;
}

// For bodies of different sizes sigma is compared relative to the size.
Placed_features relative(Placed_features features, double diagonal)
{
  for (AMF::Placed_feature& f : features) f.sigma /= diagonal;
  return features;
}

// What is measured at one gate: at the same place and time, and with the same scales.
struct Rates
{
  AMF::Repeated_features a_in_b, b_in_a, a_by_chance, b_by_chance;
  AMF::Paired_features pairs;
  std::optional<Eigen::Array2d> pairs_by_chance; // none without a mesh
};

class Repeatability : public Command
{
public:
  std::string name() const override { return "repeatability"; }
  std::string summary() const override { return "are the features of one detection found again by another one?"; }
  std::string usage() const override { return "A.json B.json [options]"; }
  bool has_curves() const override { return true; }

  std::string help() const override
  {
    return R"(Compares two detections: of an animation and a coarser or faster version of it, or of two bodies that move alike.

found again   The strongest TOP features of A are looked up among the strongest AMONG of B, and the other way round. One is
              found again if some feature is at the same place, within PLACE on the rest shape of B, and at the same time,
              within FRAMES of the coarser frames; and, more strictly, if sigma and tau are within FACTOR, too. Lists should
              be long enough for AMONG: detect with a low threshold. Chance: the same with times moved by 0.29 of the
              duration.
one-to-one    The strongest TOP of each are paired, as many as can be, each with one partner at most: the share of the shorter
              list that has a partner, within PAIR_PLACE. sigma is relative to the size of each body. Chance: B's places and
              times at random.

Without --rest-b, the refined places on the rest shapes are compared as they are, which must then lie in the same place.
The curves show all rates over gates of 0.5 to 10 % of the diagonal of B.
)";
  }

  void add_options(Option_groups& groups, std::vector<std::string>&) override
  {
    add_pair_options(groups, m_pair);
    Option_group& group = groups.add_group("What counts as the same");
    group.add("top", "N", "how many of the strongest are looked up (default: 50)",
              [&](const Argument& a) { m_top = a.count(); });
    group.add("among", "N", "among how many of the strongest (default: 150)",
              [&](const Argument& a) { m_among = a.count(); });
    group.add("place", "P%", "the largest distance, a length or a share of the diagonal of B (default: 3%)",
              [&](const Argument& a) { m_place = Programs::length(a); });
    group.add("pair-place", "P%", "the same for one-to-one (default: 5%)",
              [&](const Argument& a) { m_pair_place = Programs::length(a); });
    group.add("frames", "X", "the largest difference in time, in frames (default: 1.5)",
              [&](const Argument& a) { m_frames = a.non_negative_number(); });
    group.add("factor", "X", "the largest ratio of two values of sigma, and of tau (default: 1.5)",
              [&](const Argument& a) { m_factor = a.positive_number(); });
    groups.add_positional("files", m_pair.files, 2);
  }

  void check() override
  {
    m_pair.check(name());
    if (m_pair.rest_b.empty() && !(m_pair.map.empty() && m_pair.rest_a.empty()))
      throw AMF::Option_error("--rest-a and --map go with --rest-b, on which features are compared");
    if (m_factor < 1) throw AMF::Option_error("--factor: a ratio is at least 1");
    if (m_top == 0 || m_among == 0) throw AMF::Option_error("--top and --among: at least 1");
  }

  std::vector<std::string> input_files() const override { return m_pair.paths(); }

  Result run(const Common_options& common) override
  {
    const Feature_file a(m_pair.files[0]), b(m_pair.files[1]);
    const Placed_pair pair = placed_pair(m_pair, a, b);
    const double place = m_place.on(pair.diagonal_b), pair_place = m_pair_place.on(pair.diagonal_b);
    const Rates rates = measure(pair, place, pair_place, common);
    Result result;
    Report& report = result.report;
    report.title = "repeatability: " + a.path + " (A, " + std::to_string(pair.a.size()) + " features), " + b.path +
                   " (B, " + std::to_string(pair.b.size()) + ")";
    add_tables(rates, common, report);
    report.json = {{"measure", "repeatability"},
                   {"features", {pair.a.size(), pair.b.size()}},
                   {"files", m_pair.files},
                   {"options",
                    {{"top", m_top},
                     {"among", m_among},
                     {"place", place},
                     {"pair_place", pair_place},
                     {"frames", m_frames},
                     {"factor", m_factor}}}};
    if (m_pair.rest_b.empty())
      report.remarks.push_back("without --rest-b: places are the refined ones, and one-to-one has no chance level");
    add_curves(pair, common, result);
    return result;
  }

private:
  Rates measure(const Placed_pair& pair, double place, double pair_place, const Common_options& common) const
  {
    const double rounding = 1e-9; // of times that are a whole number of frames apart
    const double time = m_frames * pair.frame_duration + rounding;
    const AMF::Matching_gates gates = {place, time, m_factor}, pair_gates = {pair_place, time, m_factor};
    const double shift = 0.29 * pair.period;
    Rates rates;
    rates.a_in_b = AMF::repeated_features(pair.a, pair.b, m_top, m_among, gates);
    rates.b_in_a = AMF::repeated_features(pair.b, pair.a, m_top, m_among, gates);
    rates.a_by_chance =
        AMF::repeated_features(pair.a, AMF::shifted_in_time(pair.b, shift, pair.period), m_top, m_among, gates);
    rates.b_by_chance =
        AMF::repeated_features(pair.b, AMF::shifted_in_time(pair.a, shift, pair.period), m_top, m_among, gates);
    Placed_features a = relative(pair.a, pair.diagonal_a), b = relative(pair.b, pair.diagonal_b);
    a.resize((std::min)(m_top, a.size()));
    b.resize((std::min)(m_top, b.size()));
    rates.pairs = AMF::paired_features(a, b, pair_gates);
    if (pair.points_of_b.empty()) return rates;
    double last = 0;
    for (const AMF::Placed_feature& f : b) last = (std::max)(last, f.time);
    rates.pairs_by_chance = AMF::chance_level(
        b.size(), pair.points_of_b.size(), last,
        [&](const std::vector<AMF::Random_place>& places) {
          Placed_features random = b;
          for (std::size_t i = 0; i < random.size(); ++i) {
            random[i].place = pair.points_of_b[places[i].vertex];
            random[i].time = places[i].time;
          }
          const AMF::Paired_features pairs = AMF::paired_features(a, random, pair_gates);
          return Eigen::Array2d(AMF::sample_mean(pairs.in_place_and_time), AMF::sample_mean(pairs.with_scales));
        },
        common.chance);
    return rates;
  }

  static void add_tables(const Rates& rates, const Common_options& common, Report& report)
  {
    const auto figure = [&](const std::string& key, const std::string& name, const std::vector<double>& sample,
                            std::optional<double> chance) {
      return Figure{key,    name,         AMF::sample_mean(sample), AMF::bootstrap_interval(sample, common.bootstrap),
                    chance, sample.size()};
    };
    const auto direction = [&](const std::string& key, const std::string& title, const AMF::Repeated_features& r,
                               const AMF::Repeated_features& chance) {
      report.tables.push_back(
          {key,
           title,
           {figure("place_time", "place and time", r.in_place_and_time, AMF::sample_mean(chance.in_place_and_time)),
            figure("place_time_scales", "with scales", r.with_scales, AMF::sample_mean(chance.with_scales))}});
    };
    direction("a_in_b", "A found again in B", rates.a_in_b, rates.a_by_chance);
    direction("b_in_a", "B found again in A", rates.b_in_a, rates.b_by_chance);
    const auto chance = [&](int i) {
      return rates.pairs_by_chance ? std::optional<double>((*rates.pairs_by_chance)[i]) : std::nullopt;
    };
    report.tables.push_back({"one_to_one",
                             "one-to-one",
                             {figure("place_time", "place and time", rates.pairs.in_place_and_time, chance(0)),
                              figure("place_time_scales", "with scales", rates.pairs.with_scales, chance(1))}});
  }

  void add_curves(const Placed_pair& pair, const Common_options& common, Result& result) const
  {
    Programs::Curves curves;
    curves.title = "Repeatability";
    curves.subtitle = "strongest " + std::to_string(m_top) + ", " + m_pair.files[0] + " and " + m_pair.files[1];
    curves.x_name = "largest distance (% of the diagonal)";
    curves.y_name = "share";
    curves.curves = {{"A found again in B", {}, {}, false},
                     {"by chance", {}, {}, true},
                     {"B found again in A", {}, {}, false},
                     {"by chance", {}, {}, true},
                     {"one-to-one", {}, {}, false},
                     {"by chance", {}, {}, true},
                     {"one-to-one, with scales", {}, {}, false},
                     {"by chance", {}, {}, true}};
    for (int i = 1; i <= 20; ++i) {
      const double percent = 0.5 * i, place = percent / 100 * pair.diagonal_b;
      const Rates r = measure(pair, place, place, common);
      const auto add = [&](std::size_t curve, double y) {
        curves.curves[curve].x.push_back(percent);
        curves.curves[curve].y.push_back(y);
      };
      add(0, AMF::sample_mean(r.a_in_b.in_place_and_time));
      add(1, AMF::sample_mean(r.a_by_chance.in_place_and_time));
      add(2, AMF::sample_mean(r.b_in_a.in_place_and_time));
      add(3, AMF::sample_mean(r.b_by_chance.in_place_and_time));
      add(4, AMF::sample_mean(r.pairs.in_place_and_time));
      add(6, AMF::sample_mean(r.pairs.with_scales));
      if (!r.pairs_by_chance) continue;
      add(5, (*r.pairs_by_chance)[0]);
      add(7, (*r.pairs_by_chance)[1]);
    }
    result.curves = std::move(curves);
  }

  Pair_options m_pair;
  std::size_t m_top = 50, m_among = 150;
  Programs::Length m_place = {3, true}, m_pair_place = {5, true};
  double m_frames = 1.5, m_factor = 1.5;
};

} // namespace

std::unique_ptr<Command> repeatability_command()
{
  return std::make_unique<Repeatability>();
}

} // namespace Evaluate_features
