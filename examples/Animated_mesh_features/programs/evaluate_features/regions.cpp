// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "evaluate_features/Command.h"
#include "evaluate_features/Feature_file.h"
#include "evaluate_features/Painters.h"
#include "evaluate_features/write_region_mesh.h"
#include "reading/Animation.h"
#include "reading/Reading_options.h"
#include "running/Interruption.h"

#include <CGAL/Animated_mesh_features/Animation/vertex_areas.h>
#include <CGAL/Animated_mesh_features/Evaluation/Painting_scores.h>
#include <CGAL/Animated_mesh_features/Evaluation/bootstrap_interval.h>
#include <CGAL/Animated_mesh_features/Evaluation/chance_level.h>
#include <CGAL/Animated_mesh_features/Evaluation/feature_regions.h>
#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/IO/write_npy.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/Field_memory.h>

#include <algorithm>
#include <optional>

namespace AMF = CGAL::Animated_mesh_features;
using Programs::Argument;
using Programs::Option_group;
using Programs::Option_groups;

namespace Evaluate_features {

namespace {

typedef Painters::Map Map;

// Vertices that are in regions, by how many frames.
std::vector<float> column(const Map& map)
{
  std::vector<float> values;
  for (std::size_t v = 0; v < map.number_of_rows(); ++v) values.push_back(map(v, 0));
  return values;
}

class Regions : public Command
{
public:
  std::string name() const override { return "regions"; }
  std::string summary() const override { return "where and when are features, and did people see the same?"; }
  std::string usage() const override { return "FEATURES.json ANIMATION... [--truth PAINTING.json]... [options]"; }
  bool has_curves() const override { return false; }

  std::string help() const override
  {
    return R"(Makes the map of feature regions of V. Mykhalchuk, H. Seo, F. Cordier, 2014, sect. 6.2: for each vertex in how many frames
it is in a feature's region, the disc of radius sigma about the feature (along edges of the rest shape), within tau of the
feature's time; and, as a second form, with each region weighted by exp(-dt^2 / 2 tau^2). The animation is read as
detect_features reads it.

With --truth, both forms are compared with what people painted (JSON, see the manual), each vertex weighted by its area:
AUC (the area under the ROC curve), NSS (normalised scanpath saliency) and the linear correlation, in space and time and in
space alone (whether a vertex is painted in any frame); means over all painters. Beside each stands what one half of the
painters scores against the other, if there are two or more, and chance: as many features at random vertices and times.
)";
  }

  void add_options(Option_groups& groups, std::vector<std::string>&) override
  {
    Programs::add_reading_options(groups.add_group("Animation"), m_reading);
    Option_group& group = groups.add_group("Regions");
    group.add("top", "N", "how many of the strongest features (default: all)",
              [&](const Argument& a) { m_top = a.count(); });
    group.add_repeatable("truth", "FILE", "what somebody painted, repeatable; files of one painter are put together",
                         [&](const Argument& a) { m_truth.push_back(a.text()); });
    group.add("write-map", "FILE",
              "write the map, a NumPy file: N x F, the most that a region is worth there, from 0 to 1",
              [&](const Argument& a) { m_map = a.text(); });
    group.add("write-weighted-map", "FILE", "the same, weighted by the course of each event in time",
              [&](const Argument& a) { m_weighted_map = a.text(); });
    group.add("write-mesh", "FILE", "write the rest shape, coloured by the number of frames in a region (.ply)",
              [&](const Argument& a) { m_mesh = a.text(); });
    groups.add_positional("inputs", m_inputs, -1);
  }

  void check() override
  {
    if (m_inputs.size() < 2) throw AMF::Option_error("regions needs a file of features and an animation");
    m_reading.inputs.assign(m_inputs.begin() + 1, m_inputs.end());
    Programs::check(m_reading);
  }

  std::vector<std::string> input_files() const override
  {
    std::vector<std::string> all = m_reading.paths();
    all.push_back(m_inputs.front());
    all.insert(all.end(), m_truth.begin(), m_truth.end());
    return all;
  }

  std::vector<std::string> output_files() const override
  {
    std::vector<std::string> all;
    for (const std::string& path : {m_map, m_weighted_map, m_mesh})
      if (!path.empty()) all.push_back(path);
    return all;
  }

  Result run(const Common_options& common) override
  {
    const Feature_file file(m_inputs.front());
    const Programs::Animation animation(m_reading, [](std::size_t, std::size_t) { return AMF::Field_memory::heap(); });
    const AMF::Rest_shape& shape = animation.sequence().rest_shape();
    check(file, animation);
    std::vector<Feature_point> features = file.features();
    features.resize((std::min)(m_top, features.size()));
    const std::vector<double> areas = AMF::vertex_areas(shape);
    const Region_maker make = {shape, file, features};
    const Map present = make(features, AMF::Region_course::PRESENT);
    const Map weighted = make(features, AMF::Region_course::GAUSSIAN);
    Result result;
    result.report.title = "regions: " + file.path + ", " + std::to_string(features.size()) + " features";
    result.report.json = {{"measure", "regions"}, {"files", m_inputs}, {"truth", m_truth}};
    add_extent(present, areas, result.report);
    if (!m_truth.empty()) {
      const Painters painters(m_truth, file);
      const std::vector<Map> shadows = painters.shadows();
      Scores scores = {AMF::Painting_scores(painters.maps(), areas), std::nullopt};
      if (!shadows.empty())
        scores.in_space.emplace(shadows, areas);
      else
        result.report.remarks.push_back(
            "somebody painted every vertex at some time: there are no figures in space alone");
      result.report.json["painters"] = painters.maps().size();
      compare(present, AMF::Region_course::PRESENT, make, scores, common, result.report);
      compare(weighted, AMF::Region_course::GAUSSIAN, make, scores, common, result.report);
      if (painters.maps().size() < 2)
        result.report.remarks.push_back("one painter: there is nobody to agree with, and no interval");
    }
    const Programs::Interruption interruption; // now that there is something to be left on a disk
    write(shape, present, weighted);
    return result;
  }

private:
  struct Chance
  {
    AMF::Map_scores in_time, in_space;

    Chance& operator+=(const Chance& other)
    {
      in_time += other.in_time;
      in_space += other.in_space;
      return *this;
    }
    Chance& operator*=(double factor)
    {
      in_time *= factor;
      in_space *= factor;
      return *this;
    }
  };

  // in space and time, and in space alone
  struct Scores
  {
    AMF::Painting_scores in_time;
    std::optional<AMF::Painting_scores> in_space; // none: nothing to compare with
  };

  // Makes the map of features, or of the same at random places.
  struct Region_maker
  {
    const AMF::Rest_shape& shape;
    const Feature_file& file;
    const std::vector<Feature_point>& features;

    Map operator()(const std::vector<Feature_point>& f, AMF::Region_course course) const
    {
      return AMF::feature_regions(shape, file.frames(), file.frame_duration(), f, course);
    }

    Map operator()(const std::vector<AMF::Random_place>& places, AMF::Region_course course) const
    {
      std::vector<Feature_point> random = features;
      for (std::size_t i = 0; i < random.size(); ++i) {
        random[i].vertex_index = places[i].vertex;
        random[i].time = places[i].time;
      }
      return (*this)(random, course);
    }
  };

  static void compare(const Map& map, AMF::Region_course course, const Region_maker& make, const Scores& scores,
                      const Common_options& common, Report& report)
  {
    const Chance chance = AMF::chance_level(
        make.features.size(), make.shape.number_of_vertices(), make.file.duration(),
        [&](const std::vector<AMF::Random_place>& places) {
          const Map random = make(places, course);
          return Chance{scores.in_time.mean(random),
                        scores.in_space ? scores.in_space->mean(AMF::summed_over_frames(random)) : AMF::Map_scores()};
        },
        common.chance);
    const bool is_weighted = course == AMF::Region_course::GAUSSIAN;
    const std::string form = is_weighted ? ", weighted regions" : "", key = is_weighted ? "_weighted" : "";
    add_scores("space_time" + key, "in space and time" + form, scores.in_time, map, chance.in_time, common, report);
    if (scores.in_space)
      add_scores("space" + key, "in space" + form, *scores.in_space, AMF::summed_over_frames(map), chance.in_space,
                 common, report);
  }

  static void check(const Feature_file& file, const Programs::Animation& animation)
  {
    const std::size_t n = animation.sequence().rest_shape().number_of_vertices();
    const std::size_t frames = animation.sequence().number_of_frames();
    if (n != file.data.description.vertices || frames != file.frames())
      throw AMF::Input_error(file.path + ": is about " + std::to_string(file.data.description.vertices) +
                             " vertices in " + std::to_string(file.frames()) + " frames, the animation has " +
                             std::to_string(n) + " in " + std::to_string(frames));
  }

  // How much of the surface is in regions, and for how long.
  static void add_extent(const Map& map, const std::vector<double>& areas, Report& report)
  {
    const Map sums = AMF::summed_over_frames(map);
    double all = 0, ever = 0, always = 0;
    for (std::size_t v = 0; v < areas.size(); ++v) {
      all += areas[v];
      ever += sums(v, 0) > 0 ? areas[v] : 0;
      always += areas[v] * double(sums(v, 0)) / double(map.number_of_frames());
    }
    report.tables.push_back(
        {"extent",
         "share of the surface in regions",
         {{"any_frame", "in any frame", ever / all, std::nullopt, std::nullopt, std::nullopt},
          {"mean", "mean over the frames", always / all, std::nullopt, std::nullopt, std::nullopt}}});
  }

  static void add_scores(const std::string& key, const std::string& title, const AMF::Painting_scores& scores,
                         const Map& map, const AMF::Map_scores& chance, const Common_options& common, Report& report)
  {
    const std::vector<AMF::Map_scores> of_painters = scores(map);
    const bool is_sample = of_painters.size() > 1;
    const AMF::Map_scores ceiling =
        is_sample ? scores.split_half(common.chance.draws, common.chance.seed) : AMF::Map_scores();
    Table table = {key, title, {}};
    const auto add = [&](const std::string& figure, const std::string& name, double AMF::Map_scores::*member) {
      std::vector<double> sample;
      for (const AMF::Map_scores& s : of_painters) sample.push_back(s.*member);
      Figure f = {figure, name, AMF::sample_mean(sample), std::nullopt, chance.*member, sample.size()};
      if (is_sample) f.interval = AMF::bootstrap_interval(sample, common.bootstrap);
      table.figures.push_back(f);
      if (is_sample)
        table.figures.push_back({figure + "_split_half", "  painters among themselves", ceiling.*member, std::nullopt,
                                 std::nullopt, sample.size()});
    };
    add("auc", "AUC", &AMF::Map_scores::auc);
    add("nss", "NSS", &AMF::Map_scores::nss);
    add("correlation", "correlation", &AMF::Map_scores::correlation);
    report.tables.push_back(table);
  }

  void write(const AMF::Rest_shape& shape, const Map& present, const Map& weighted) const
  {
    std::optional<AMF::IO::Output_file> map, weighted_map, mesh;
    const auto open = [](std::optional<AMF::IO::Output_file>& file, const std::string& path, const auto& write) {
      if (path.empty()) return;
      file.emplace(path);
      write(file->stream());
      file->stream().flush();
      file->check();
    };
    open(map, m_map, [&](std::ostream& os) { AMF::IO::write_npy(os, present); });
    open(weighted_map, m_weighted_map, [&](std::ostream& os) { AMF::IO::write_npy(os, weighted); });
    open(mesh, m_mesh,
         [&](std::ostream& os) { write_region_mesh(os, shape, column(AMF::summed_over_frames(present))); });
    for (auto* file : {&map, &weighted_map, &mesh})
      if (*file) (*file)->commit();
  }

  Programs::Reading_options m_reading;
  std::vector<std::string> m_inputs, m_truth;
  std::size_t m_top = std::size_t(-1);
  std::string m_map, m_weighted_map, m_mesh; // files; empty: none
};

} // namespace

std::unique_ptr<Command> regions_command()
{
  return std::make_unique<Regions>();
}

} // namespace Evaluate_features
