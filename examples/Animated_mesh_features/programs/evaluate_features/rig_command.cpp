// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "evaluate_features/Command.h"
#include "evaluate_features/Feature_file.h"
#include "evaluate_features/Rig.h"

#include <CGAL/Animated_mesh_features/Evaluation/Rig_events.h>
#include <CGAL/Animated_mesh_features/Evaluation/bootstrap_interval.h>
#include <CGAL/Animated_mesh_features/Evaluation/chance_level.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <Eigen/Core>

#include <algorithm>

namespace AMF = CGAL::Animated_mesh_features;
using Programs::Argument;
using Programs::Option_group;
using Programs::Option_groups;

namespace Evaluate_features {

namespace {

std::vector<AMF::Rig_feature> rig_features(const Feature_file& file, std::size_t top)
{
  std::vector<AMF::Rig_feature> result;
  for (std::size_t i = 0; i < (std::min)(top, file.features().size()); ++i) {
    const Feature_point& f = file.features()[i];
    const auto& file_vertices = file.data.file_vertices;
    result.push_back({file_vertices.empty() ? f.vertex_index : file_vertices[i].front(), f.time, f.sigma, f.tau});
  }
  return result;
}

// The vertices of a mesh are its own, those of a model the file's.
std::vector<AMF::Rig_feature> rig_features(const Feature_file& file, std::size_t top, const Rig_source& source)
{
  if (!source.model.empty()) return rig_features(file, top);
  Feature_file own = file;
  own.data.file_vertices.clear();
  return rig_features(own, top);
}

class Rig_command : public Command
{
public:
  std::string name() const override { return "rig"; }
  std::string summary() const override { return "are features where and when the joints of a skeleton are bent most?"; }
  std::string usage() const override
  {
    return "FEATURES.json... --events FILE --rest MESH | --model FILE --clip NAME [options]";
  }
  bool has_curves() const override { return true; }

  std::string help() const override
  {
    return R"(Compares features with the events of a skeleton: the moments at which the angle of a joint against rest has a local maximum
with a prominence of 10 degrees or more. A feature is at an event if its vertex is within min(sigma, 2 % of the diagonal) of
the region of the joint, and its time within max(1.5 frames, tau / 2). Events in the first and the last two frames do not
count.

recall      of the events of 20 degrees and more, how many have a feature
precision   of the features, how many are at an event of 10 degrees and more

Chance: as many features of the same scales at random vertices and times. Several files of features are measured one by one,
with a table for each; the table by joint, how many of its events have a feature, is in the JSON file, too.
)";
  }

  void add_options(Option_groups& groups, std::vector<std::string>&) override
  {
    Option_group& group = groups.add_group("The skeleton");
    group.add("events", "FILE", "events and regions of its joints: JSON, as make_animation figure --events writes it",
              [&](const Argument& a) { m_source.events = a.text(); });
    group.add("rest", "MESH", "with --events: the rest shape on which the features were found",
              [&](const Argument& a) { m_source.rest = a.text(); });
    group.add("model", "FILE", "or a model with a skeleton, glTF (.glb, .gltf), on which the features were found",
              [&](const Argument& a) { m_source.model = a.text(); });
    group.add("clip", "NAME", "with --model: which clip, as for detect_features (default: the first)",
              [&](const Argument& a) { m_source.clip = a.text(); });
    group.add_switch("there-and-back", m_source.there_and_back,
                     "with --model: it was played to its end and back again");
    Option_group& what = groups.add_group("What is measured");
    what.add("top", "N", "how many of the strongest features (default: all)",
             [&](const Argument& a) { m_top = a.count(); });
    groups.add_positional("files", m_files, -1);
  }

  void check() override
  {
    if (m_files.empty()) throw AMF::Option_error("rig needs a file of features");
    if (m_source.events.empty() == m_source.model.empty())
      throw AMF::Option_error("rig needs the truth: either --events or --model");
    if (m_source.events.empty() != m_source.rest.empty())
      throw AMF::Option_error("--events and --rest go together, --model has its own rest shape");
    if (m_source.model.empty() && (!m_source.clip.empty() || m_source.there_and_back))
      throw AMF::Option_error("--clip and --there-and-back go with --model");
  }

  std::vector<std::string> input_files() const override
  {
    std::vector<std::string> all = m_files;
    for (const std::string& path : {m_source.events, m_source.rest, m_source.model})
      if (!path.empty()) all.push_back(path);
    return all;
  }

  Result run(const Common_options& common) override
  {
    Result result;
    result.report.title = "rig: " + (m_source.model.empty() ? m_source.events : m_source.model + " " + m_source.clip);
    result.report.json = {{"measure", "rig"}, {"files", m_files}, {"joints", Report::Json::object()}};
    Programs::Curves curves;
    curves.title = "Events of a skeleton";
    curves.subtitle = result.report.title;
    curves.x_name = "strongest features";
    curves.y_name = "share";
    for (std::size_t i = 0; i < m_files.size(); ++i) measure(m_files[i], i, common, result.report, curves);
    result.curves = std::move(curves);
    return result;
  }

private:
  void measure(const std::string& path, std::size_t number, const Common_options& common, Report& report,
               Programs::Curves& curves) const
  {
    const Feature_file file(path);
    const Rig rig = read_rig(m_source, file);
    const std::vector<AMF::Rig_feature> features = rig_features(file, m_top, m_source);
    const AMF::Rig_events events(rig.points, diagonal(rig.points), rig.regions(), rig.events(), rig.data.frames,
                                 rig.data.frame_duration);
    const AMF::Rig_matches matches = events(features);
    const Eigen::Array2d chance = AMF::chance_level(
        features.size(), rig.points.size(), file.duration(),
        [&](const std::vector<AMF::Random_place>& places) {
          std::vector<AMF::Rig_feature> random = features;
          for (std::size_t i = 0; i < random.size(); ++i) {
            random[i].vertex = places[i].vertex;
            random[i].time = places[i].time;
          }
          const AMF::Rig_matches m = events(random);
          return Eigen::Array2d(AMF::sample_mean(m.found), AMF::sample_mean(m.at_event));
        },
        common.chance);

    const bool has_events = !events.recalled().empty();
    Figure recall = {"recall", "recall", std::nullopt, std::nullopt, std::nullopt, matches.found.size()};
    if (has_events) {
      recall.value = AMF::sample_mean(matches.found);
      recall.interval = AMF::bootstrap_interval(matches.found, common.bootstrap);
      recall.chance = chance[0];
    }
    const std::string key = m_files.size() == 1 ? "all" : std::to_string(number);
    report.tables.push_back(
        {key,
         path + ", " + std::to_string(features.size()) + " features",
         {recall,
          {"precision", "precision", AMF::sample_mean(matches.at_event),
           AMF::bootstrap_interval(matches.at_event, common.bootstrap), chance[1], matches.at_event.size()}}});
    if (!has_events) report.remarks.push_back(path + ": no event counts, so there is no recall");
    report.json["joints"][key] = add_joints(rig, events, matches, m_files.size() == 1 ? &report : nullptr);
    add_curve(path, events, features, curves);
  }

  // The joints that have events: how many, how many found, how many features; also in the table, if there is one file.
  static Report::Json add_joints(const Rig& rig, const AMF::Rig_events& events, const AMF::Rig_matches& matches,
                                 Report* report)
  {
    std::vector<std::vector<double>> found(events.number_of_joints());
    for (std::size_t i = 0; i < matches.found.size(); ++i)
      found[events.recalled()[i].joint].push_back(matches.found[i]);
    Report::Json json = Report::Json::array();
    Table table = {"by_joint", "events found, by joint", {}};
    for (std::size_t j = 0; j < found.size(); ++j) {
      if (found[j].empty() && matches.of_joint[j] == 0) continue;
      const std::string& name = rig.data.joints[j].name;
      const double sum = AMF::sample_mean(found[j]) * double(found[j].size());
      json.push_back({{"name", name},
                      {"region", rig.data.joints[j].region.size()},
                      {"events", found[j].size()},
                      {"found", std::size_t(sum + 0.5)},
                      {"features", matches.of_joint[j]}});
      if (!found[j].empty())
        table.figures.push_back(
            {std::to_string(j), name, AMF::sample_mean(found[j]), std::nullopt, std::nullopt, found[j].size()});
    }
    if (report != nullptr && !table.figures.empty()) report->tables.push_back(table);
    return json;
  }

  // Recall and precision of the strongest 1, 2, 3...
  static void add_curve(const std::string& path, const AMF::Rig_events& events,
                        const std::vector<AMF::Rig_feature>& features, Programs::Curves& curves)
  {
    Programs::Curve recall = {"recall, " + path, {}, {}, false}, precision = {"precision, " + path, {}, {}, false};
    const std::size_t steps = 60;
    for (std::size_t i = 1; i <= steps && !features.empty(); ++i) {
      const std::size_t n = (features.size() * i + steps - 1) / steps;
      const AMF::Rig_matches m =
          events(std::vector<AMF::Rig_feature>(features.begin(), features.begin() + std::ptrdiff_t(n)));
      recall.x.push_back(double(n));
      recall.y.push_back(AMF::sample_mean(m.found));
      precision.x.push_back(double(n));
      precision.y.push_back(AMF::sample_mean(m.at_event));
    }
    curves.curves.push_back(recall);
    curves.curves.push_back(precision);
  }

  Rig_source m_source;
  std::vector<std::string> m_files;
  std::size_t m_top = std::size_t(-1);
};

} // namespace

std::unique_ptr<Command> rig_command()
{
  return std::make_unique<Rig_command>();
}

} // namespace Evaluate_features
