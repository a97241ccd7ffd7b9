// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EVALUATE_FEATURES_REPORT_H
#define EVALUATE_FEATURES_REPORT_H

#include <CGAL/Animated_mesh_features/Evaluation/bootstrap_interval.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace Evaluate_features {

// A number with what stands beside it. What is not defined is not there.
struct Figure
{
  std::string key;  // in the JSON file
  std::string name; // in the table
  std::optional<double> value;
  std::optional<CGAL::Animated_mesh_features::Interval> interval;
  std::optional<double> chance;
  std::optional<std::size_t> sample; // its size
};

// A table of figures under a title.
struct Table
{
  std::string key, title;
  std::vector<Figure> figures;
};

// All that an evaluation has found.
struct Report
{
  typedef nlohmann::ordered_json Json;

  std::string title; // what was compared
  std::vector<Table> tables;
  std::vector<std::string> remarks; // under the tables: a sentence each
  Json json = Json::object();       // the measure, its inputs and options, and what else there is besides the tables
};

// As people read it: numbers with three decimals.
std::string text_of(const Report& report);

// As programs read it: `Report::json` with the tables' figures.
std::string json_text_of(const Report& report);

} // namespace Evaluate_features

#endif // EVALUATE_FEATURES_REPORT_H
