// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "evaluate_features/Command.h"
#include "evaluate_features/Correspondence.h"
#include "evaluate_features/Feature_file.h"

#include <CGAL/Animated_mesh_features/Evaluation/bootstrap_interval.h>
#include <CGAL/Animated_mesh_features/Evaluation/chance_level.h>
#include <CGAL/Animated_mesh_features/Evaluation/matching_errors.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace AMF = CGAL::Animated_mesh_features;
using Programs::Argument;
using Programs::Option_group;
using Programs::Option_groups;

namespace Evaluate_features {

namespace {

typedef std::vector<AMF::Feature_on_shape> Features;

// The errors of one direction, in one form, in % of the diagonal.
struct Errors
{
  std::string key, name;
  std::vector<double> errors;
  std::vector<double> by_chance; // of all draws
};

double share_within(const std::vector<double>& errors, double percent)
{
  std::size_t n = 0;
  for (double e : errors) n += e <= percent ? 1 : 0;
  return errors.empty() ? 0 : double(n) / double(errors.size());
}

class Matching_error : public Command
{
public:
  std::string name() const override { return "matching-error"; }
  std::string summary() const override
  {
    return "how far from the features of one detection are those of another one?";
  }
  std::string usage() const override { return "A.json B.json --rest-b MESH [options]"; }
  bool has_curves() const override { return true; }

  std::string help() const override
  {
    return R"(Measures the matching error of V. Mykhalchuk, H. Seo, F. Cordier, 2014, sect. 6.1: for each feature the distance to the
nearest one of the other detection, along edges of the rest shape of B, in % of its diagonal. In two forms, places only, and
among features that are at the same time, within FRAMES of the coarser frames; in both directions. Chance: the distances from
as many random places and times.
)";
  }

  void add_options(Option_groups& groups, std::vector<std::string>&) override
  {
    add_pair_options(groups, m_pair);
    Option_group& group = groups.add_group("What is compared");
    group.add("top", "N", "how many of the strongest of each (default: all)",
              [&](const Argument& a) { m_top = a.count(); });
    group.add("frames", "X", "the largest difference in time, in frames (default: 1.5)",
              [&](const Argument& a) { m_frames = a.non_negative_number(); });
    groups.add_positional("files", m_pair.files, 2);
  }

  void check() override
  {
    m_pair.check(name());
    if (m_pair.rest_b.empty()) throw AMF::Option_error("--rest-b is needed: errors are measured on it");
  }

  std::vector<std::string> input_files() const override { return m_pair.paths(); }

  Result run(const Common_options& common) override
  {
    const Feature_file a(m_pair.files[0]), b(m_pair.files[1]);
    const AMF::Rest_shape shape = read_shape(m_pair.rest_b, b);
    const std::vector<std::size_t> vertices = corresponding_vertices(m_pair, a, b, shape.points());
    Features of_a, of_b;
    for (std::size_t i = 0; i < (std::min)(m_top, vertices.size()); ++i)
      of_a.push_back({AMF::Rest_shape::Index(vertices[i]), a.features()[i].time});
    for (std::size_t i = 0; i < (std::min)(m_top, b.features().size()); ++i)
      of_b.push_back({AMF::Rest_shape::Index(b.features()[i].vertex_index), b.features()[i].time});
    m_time = m_frames * (std::max)(a.frame_duration(), b.frame_duration()) + 1e-9;
    m_duration = (std::max)(a.duration(), b.duration());

    std::vector<Errors> all;
    for (const bool is_timed : {false, true}) {
      const std::string key = is_timed ? "_place_time" : "_place", name = is_timed ? ", same time" : ", any time";
      all.push_back(errors("a_to_b" + key, "from A to B" + name, shape, of_a, of_b, is_timed, common));
      all.push_back(errors("b_to_a" + key, "from B to A" + name, shape, of_b, of_a, is_timed, common));
    }
    Result result;
    result.report.title = "matching error: " + a.path + " (A, " + std::to_string(of_a.size()) + " features), " +
                          b.path + " (B, " + std::to_string(of_b.size()) + ")";
    result.report.json = {{"measure", "matching-error"},
                          {"features", {of_a.size(), of_b.size()}},
                          {"files", m_pair.files},
                          {"options", {{"frames", m_frames}, {"diagonal", shape.bounding_box_diagonal()}}}};
    for (const Errors& e : all) {
      add_table(e, common, result.report);
      result.report.json["errors"][e.key] = e.errors; // what is infinite becomes null
    }
    result.curves = curves(all);
    return result;
  }

private:
  std::vector<double> measured(const AMF::Rest_shape& shape, const Features& features, const Features& others,
                               bool is_timed) const
  {
    std::vector<double> errors = is_timed ? AMF::matching_errors(shape, features, others, m_time)
                                          : AMF::matching_errors(shape, features, others);
    for (double& e : errors) e *= 100 / shape.bounding_box_diagonal();
    return errors;
  }

  Errors errors(const std::string& key, const std::string& name, const AMF::Rest_shape& shape, const Features& features,
                const Features& others, bool is_timed, const Common_options& common) const
  {
    Errors result = {key, name, measured(shape, features, others, is_timed), {}};
    Features random;
    AMF::chance_level(
        features.size(), shape.number_of_vertices(), m_duration,
        [&](const std::vector<AMF::Random_place>& places) {
          for (const AMF::Random_place& p : places) random.push_back({AMF::Rest_shape::Index(p.vertex), p.time});
          return 0.; // all draws are measured at once
        },
        common.chance);
    result.by_chance = measured(shape, random, others, is_timed);
    return result;
  }

  static void add_table(const Errors& e, const Common_options& common, Report& report)
  {
    Table table = {e.key, "error " + e.name, {}};
    const double median = AMF::sample_median(e.errors), by_chance = AMF::sample_median(e.by_chance);
    const AMF::Interval interval = AMF::bootstrap_interval(e.errors, AMF::sample_median, common.bootstrap);
    const auto finite = [](double x) { return std::isfinite(x) ? std::optional<double>(x) : std::nullopt; };
    Figure f = {"median", "median (%)", finite(median), std::nullopt, finite(by_chance), e.errors.size()};
    if (std::isfinite(interval.high)) f.interval = interval;
    table.figures.push_back(f);
    for (const int percent : {1, 2, 3, 5, 10}) {
      std::vector<double> sample;
      for (double x : e.errors) sample.push_back(x <= percent ? 1 : 0);
      table.figures.push_back({"within_" + std::to_string(percent) + "_percent",
                               "share within " + std::to_string(percent) + " %", AMF::sample_mean(sample),
                               AMF::bootstrap_interval(sample, common.bootstrap), share_within(e.by_chance, percent),
                               sample.size()});
    }
    report.tables.push_back(table);
  }

  static Programs::Curves curves(const std::vector<Errors>& all)
  {
    Programs::Curves curves;
    curves.title = "Matching error";
    curves.subtitle = "share of features whose nearest counterpart is at most as far";
    curves.x_name = "error (% of the diagonal)";
    curves.y_name = "share";
    for (const Errors& e : all) {
      Programs::Curve of_features = {e.name, {}, {}, false}, of_chance = {"by chance", {}, {}, true};
      for (int i = 0; i <= 40; ++i) {
        const double percent = 0.5 * i;
        of_features.x.push_back(percent);
        of_features.y.push_back(share_within(e.errors, percent));
        of_chance.x.push_back(percent);
        of_chance.y.push_back(share_within(e.by_chance, percent));
      }
      curves.curves.push_back(of_features);
      curves.curves.push_back(of_chance);
    }
    return curves;
  }

  Pair_options m_pair;
  std::size_t m_top = std::size_t(-1);
  double m_frames = 1.5;
  double m_time = 0, m_duration = 0; // seconds
};

} // namespace

std::unique_ptr<Command> matching_error_command()
{
  return std::make_unique<Matching_error>();
}

} // namespace Evaluate_features
