// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "evaluate_features/Command.h"
#include "evaluate_features/Feature_file.h"

#include <CGAL/Animated_mesh_features/Animation/vertex_areas.h>
#include <CGAL/Animated_mesh_features/Detection/feature_fit.h>
#include <CGAL/Animated_mesh_features/Evaluation/bootstrap_interval.h>
#include <CGAL/Animated_mesh_features/Evaluation/chance_level.h>
#include <CGAL/Animated_mesh_features/IO/read_npy.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>

namespace AMF = CGAL::Animated_mesh_features;
using Programs::Argument;
using Programs::Option_group;
using Programs::Option_groups;

namespace Evaluate_features {

namespace {

typedef AMF::Spatio_temporal_field<float> Field;

struct Measured_feature
{
  Feature_point feature;
  AMF::Feature_fit fit;
};

Field read_field(const std::string& file, const Feature_file& features)
{
  Field field = AMF::IO::read_npy<float>(file);
  const auto& d = features.data.description;
  if (field.number_of_rows() != d.vertices || field.number_of_frames() != d.frames)
    throw AMF::Input_error(file + ": is " + std::to_string(field.number_of_rows()) + " x " +
                           std::to_string(field.number_of_frames()) + ", the features of " + features.path +
                           " were found on " + std::to_string(d.vertices) + " vertices in " + std::to_string(d.frames) +
                           " frames");
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f)
      if (!std::isfinite(field(v, f)))
        throw AMF::Input_error(file + ": frame " + std::to_string(f) + ": is not finite at vertex " +
                               std::to_string(v));
  return field;
}

class Fit : public Command
{
public:
  std::string name() const override { return "fit"; }
  std::string summary() const override { return "do features describe the field in which they were found?"; }
  std::string usage() const override { return "FEATURES.json FIELD.npy REST_MESH [options]"; }
  bool has_curves() const override { return true; }

  std::string help() const override
  {
    return R"(For each feature the correlation, weighted by area, of the field with exp(-d^2 / 2 sigma^2) exp(-dt^2 / 2 tau^2), over the
vertices within 2.5 sigma (along edges of the rest shape) and the frames within 2.5 tau, across the end if the features were
found with --cyclic; and the area of the disc of radius sqrt(2) sigma over that of a flat one. FIELD is what detect_features --write-field deformation:FIELD.npy writes. Chance: as
many features of the same scales at random vertices and times.
)";
  }

  void add_options(Option_groups& groups, std::vector<std::string>&) override
  {
    Option_group& group = groups.add_group("What is measured");
    group.add("top", "N", "how many of the strongest features (default: all)",
              [&](const Argument& a) { m_top = a.count(); });
    groups.add_positional("files", m_files, 3);
  }

  void check() override
  {
    if (m_files.size() != 3) throw AMF::Option_error("fit needs a file of features, a field and the rest shape");
  }

  std::vector<std::string> input_files() const override { return m_files; }

  Result run(const Common_options& common) override
  {
    const Feature_file file(m_files[0]);
    const Field field = read_field(m_files[1], file);
    const AMF::Rest_shape shape = read_shape(m_files[2], file);
    const std::vector<double> areas = AMF::vertex_areas(shape);
    AMF::Feature_fit_measure<float> measure(shape, areas, field, file.frame_duration(), file.is_cyclic());
    std::vector<Measured_feature> measured;
    for (std::size_t i = 0; i < (std::min)(m_top, file.features().size()); ++i)
      measured.push_back({file.features()[i], measure(file.features()[i])});

    const std::vector<double> by_chance = fits_by_chance(measured, measure, shape, file, common);
    Result result;
    Report& report = result.report;
    report.title = "fit: " + file.path + ", " + std::to_string(measured.size()) + " features";
    report.json = {{"measure", "fit"}, {"files", m_files}, {"features", Report::Json::array()}};
    for (const Measured_feature& m : measured)
      report.json["features"].push_back({{"vertex", m.feature.vertex_index},
                                         {"time", m.feature.time},
                                         {"sigma", m.feature.sigma},
                                         {"tau", m.feature.tau},
                                         {"fit", m.fit.fit},
                                         {"area_ratio", m.fit.area_ratio}});
    add_table(measured, by_chance, common, report);
    add_tables_by_size(measured, file.data.description.bounding_box_diagonal, common, report);
    add_curves(measured, by_chance, result);
    return result;
  }

private:
  // Of all draws together.
  static std::vector<double> fits_by_chance(const std::vector<Measured_feature>& measured,
                                            AMF::Feature_fit_measure<float>& measure, const AMF::Rest_shape& shape,
                                            const Feature_file& file, const Common_options& common)
  {
    std::vector<double> fits;
    AMF::chance_level(
        measured.size(), shape.number_of_vertices(), file.duration(),
        [&](const std::vector<AMF::Random_place>& places) {
          for (std::size_t i = 0; i < places.size(); ++i) {
            Feature_point f = measured[i].feature;
            f.vertex_index = places[i].vertex;
            f.time = places[i].time;
            fits.push_back(measure(f).fit);
          }
          return 0.;
        },
        common.chance);
    return fits;
  }

  static double share_below(const std::vector<double>& values, double bound)
  {
    std::size_t n = 0;
    for (double x : values) n += x < bound ? 1 : 0;
    return values.empty() ? 0 : double(n) / double(values.size());
  }

  static std::vector<double> fits_of(const std::vector<Measured_feature>& measured)
  {
    std::vector<double> fits;
    for (const Measured_feature& m : measured) fits.push_back(m.fit.fit);
    return fits;
  }

  static void add_table(const std::vector<Measured_feature>& measured, const std::vector<double>& by_chance,
                        const Common_options& common, Report& report)
  {
    const std::vector<double> fits = fits_of(measured);
    std::vector<double> is_low, is_at_limit;
    for (const Measured_feature& m : measured) {
      is_low.push_back(m.fit.fit < 0.3 ? 1 : 0);
      is_at_limit.push_back(m.feature.at_scale_limit ? 1 : 0);
    }
    report.tables.push_back(
        {"all",
         "all features",
         {{"median", "median of the fit", AMF::sample_median(fits),
           AMF::bootstrap_interval(fits, AMF::sample_median, common.bootstrap), AMF::sample_median(by_chance),
           fits.size()},
          {"below_0.3", "share below 0.3", AMF::sample_mean(is_low), AMF::bootstrap_interval(is_low, common.bootstrap),
           share_below(by_chance, 0.3), fits.size()},
          {"at_scale_limit", "share at a limit of the scales", AMF::sample_mean(is_at_limit),
           AMF::bootstrap_interval(is_at_limit, common.bootstrap), std::nullopt, fits.size()}}});
  }

  static void add_tables_by_size(const std::vector<Measured_feature>& measured, double diagonal,
                                 const Common_options& common, Report& report)
  {
    const std::vector<std::pair<double, double>> ranges = {{0, 1.5}, {1.5, 2.5}, {2.5, 4}, {4, 7}, {7, 12}, {12, 99}};
    for (const auto& range : ranges) {
      std::vector<double> fits, ratios;
      for (const Measured_feature& m : measured) {
        const double percent = m.feature.sigma / diagonal * 100;
        if (!(percent >= range.first && percent < range.second)) continue;
        fits.push_back(m.fit.fit);
        ratios.push_back(m.fit.area_ratio);
      }
      if (fits.empty()) continue;
      const auto text = [](double x) {
        std::string s = std::to_string(x);
        s.erase(s.find_last_not_of('0') + 1);
        if (s.back() == '.') s.pop_back();
        return s;
      };
      const std::string name = text(range.first) + " to " + text(range.second);
      report.tables.push_back(
          {"sigma_" + text(range.first) + "_" + text(range.second),
           "sigma " + name + " % of the diagonal",
           {{"median", "median of the fit", AMF::sample_median(fits),
             AMF::bootstrap_interval(fits, AMF::sample_median, common.bootstrap), std::nullopt, fits.size()},
            {"least", "least fit", *std::min_element(fits.begin(), fits.end()), std::nullopt, std::nullopt,
             fits.size()},
            {"area_ratio", "median of the area ratio", AMF::sample_median(ratios),
             AMF::bootstrap_interval(ratios, AMF::sample_median, common.bootstrap), std::nullopt, fits.size()}}});
    }
  }

  static void add_curves(const std::vector<Measured_feature>& measured, const std::vector<double>& by_chance,
                         Result& result)
  {
    Programs::Curves curves;
    curves.title = "Fit";
    curves.subtitle = result.report.title;
    curves.x_name = "fit";
    curves.y_name = "share of features with less";
    curves.curves = {{"features", {}, {}, false}, {"by chance", {}, {}, true}};
    const std::vector<double> fits = fits_of(measured);
    for (int i = -20; i <= 20; ++i) {
      const double fit = 0.05 * i;
      curves.curves[0].x.push_back(fit);
      curves.curves[0].y.push_back(share_below(fits, fit));
      curves.curves[1].x.push_back(fit);
      curves.curves[1].y.push_back(share_below(by_chance, fit));
    }
    result.curves = std::move(curves);
  }

  std::vector<std::string> m_files;
  std::size_t m_top = std::size_t(-1);
};

} // namespace

std::unique_ptr<Command> fit_command()
{
  return std::make_unique<Fit>();
}

} // namespace Evaluate_features
