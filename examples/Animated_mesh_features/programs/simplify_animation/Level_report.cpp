// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "simplify_animation/Level_report.h"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <sstream>

namespace AMF = CGAL::Animated_mesh_features;

namespace Simplify_animation {

namespace {

typedef AMF::Simplification_error Error;

template <class Value>
double mean_of(const Level_errors& level, const Value& value)
{
  double sum = 0;
  for (const Error& e : level.frames) sum += value(e);
  return sum / double(level.frames.size());
}

template <class Value>
double most_of(const Level_errors& level, const Value& value)
{
  double most = 0;
  for (const Error& e : level.frames) most = (std::max)(most, double(value(e)));
  return most;
}

// of all frames together
double mean_in_regions(const Level_errors& level)
{
  double sum = 0, share = 0;
  for (const Error& e : level.frames) {
    sum += e.mean_in_regions * e.share_in_regions;
    share += e.share_in_regions;
  }
  return share > 0 ? sum / share : 0;
}

double mean_elsewhere(const Level_errors& level)
{
  double sum = 0, share = 0;
  for (const Error& e : level.frames) {
    sum += e.mean_elsewhere * (1 - e.share_in_regions);
    share += 1 - e.share_in_regions;
  }
  return share > 0 ? sum / share : 0;
}

double mean(const Error& e)
{
  return e.mean();
}

} // namespace

std::string text_of(const Level_report& report)
{
  std::ostringstream os;
  os.imbue(std::locale::classic());
  const double unit = 100 / report.diagonal;
  os << report.title << ": " << report.vertices << " vertices, " << report.triangles << " triangles; "
     << report.poses.size() << (report.poses.size() == 1 ? " pose" : " poses") << "\ndistances in % of the diagonal\n\n"
     << std::right << std::setw(10) << "vertices" << std::setw(10) << "triangles" << std::setw(9) << "mean"
     << std::setw(9) << "worst" << std::setw(7) << "frame" << std::setw(11) << "Hausdorff";
  if (report.has_regions) os << std::setw(12) << "in features" << std::setw(11) << "elsewhere";
  os << std::setw(10) << "normals" << std::setw(8) << "turned" << '\n';
  os << std::fixed;
  for (const Level_errors& level : report.levels) {
    const Error& worst = AMF::worst_frame(level.frames);
    os << std::setw(10) << level.vertices << std::setw(10) << level.triangles << std::setprecision(4) << std::setw(9)
       << unit * mean_of(level, mean) << std::setw(9) << unit * worst.mean() << std::setw(7) << worst.frame
       << std::setprecision(3) << std::setw(11) << unit * most_of(level, [](const Error& e) { return e.hausdorff(); });
    if (report.has_regions)
      os << std::setprecision(4) << std::setw(12) << unit * mean_in_regions(level) << std::setw(11)
         << unit * mean_elsewhere(level);
    os << std::setprecision(2) << std::setw(8) << mean_of(level, [](const Error& e) { return e.normal_angle; }) << " d"
       << std::setw(8) << std::size_t(most_of(level, [](const Error& e) { return e.turned; })) << '\n';
  }
  return os.str();
}

nlohmann::ordered_json json_of(const Level_report& report)
{
  typedef nlohmann::ordered_json Json;
  const double unit = 100 / report.diagonal;
  Json json = {{"format", "animated-mesh-features-simplification"},
               {"version", 1},
               {"animation", report.title},
               {"vertices", report.vertices},
               {"triangles", report.triangles},
               {"diagonal", report.diagonal},
               {"unit", "% of the diagonal"},
               {"poses", report.poses},
               {"levels", Json::array()}};
  for (const Level_errors& level : report.levels) {
    const Error& worst = AMF::worst_frame(level.frames);
    Json l = {{"vertices", level.vertices},
              {"triangles", level.triangles},
              {"mean", unit * mean_of(level, mean)},
              {"worst_frame", worst.frame},
              {"worst_mean", unit * worst.mean()},
              {"hausdorff", unit * most_of(level, [](const Error& e) { return e.hausdorff(); })},
              {"normal_angle_deg", mean_of(level, [](const Error& e) { return e.normal_angle; })},
              {"turned", std::size_t(most_of(level, [](const Error& e) { return e.turned; }))},
              {"turned_in_original", std::size_t(most_of(level, [](const Error& e) { return e.turned_in_original; }))}};
    if (report.has_regions) {
      l["mean_in_features"] = unit * mean_in_regions(level);
      l["mean_elsewhere"] = unit * mean_elsewhere(level);
    }
    l["frames"] = Json::array();
    for (const Error& e : level.frames) {
      Json f = {{"frame", e.frame},
                {"mean_to_original", unit * e.mean_to_original},
                {"mean_to_coarse", unit * e.mean_to_coarse},
                {"max_to_original", unit * e.max_to_original},
                {"max_to_coarse", unit * e.max_to_coarse},
                {"normal_angle_deg", e.normal_angle},
                {"turned", e.turned},
                {"turned_in_original", e.turned_in_original}};
      if (report.has_regions) {
        f["mean_in_features"] = unit * e.mean_in_regions;
        f["mean_elsewhere"] = unit * e.mean_elsewhere;
        f["share_in_features"] = e.share_in_regions;
      }
      l["frames"].push_back(f);
    }
    json["levels"].push_back(l);
  }
  return json;
}

Programs::Curves curves_of(const Level_report& report)
{
  Programs::Curves curves;
  curves.title = "Errors of simplification";
  curves.subtitle = report.title;
  curves.x_name = "frame";
  curves.y_name = "mean distance, % of the diagonal";
  const double unit = 100 / report.diagonal;
  curves.y_max = 0;
  for (const Level_errors& level : report.levels) {
    Programs::Curve curve;
    curve.name = std::to_string(level.vertices) + " vertices";
    for (const Error& e : level.frames) {
      curve.x.push_back(double(e.frame));
      curve.y.push_back(unit * e.mean());
      curves.y_max = (std::max)(curves.y_max, curve.y.back());
    }
    curves.curves.push_back(curve);
  }
  return curves;
}

} // namespace Simplify_animation
