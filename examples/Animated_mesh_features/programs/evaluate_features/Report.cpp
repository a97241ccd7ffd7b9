// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "evaluate_features/Report.h"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <sstream>

namespace Evaluate_features {

namespace {

std::string decimals(double x)
{
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os << std::fixed << std::setprecision(3) << x;
  return os.str();
}

std::string cell(const std::optional<double>& x)
{
  return x ? decimals(*x) : "-";
}

Report::Json json_of(const Figure& f)
{
  const auto number = [](const std::optional<double>& x) { return x ? Report::Json(*x) : Report::Json(); };
  Report::Json json = {{"value", number(f.value)}, {"chance", number(f.chance)}};
  json["interval"] = f.interval ? Report::Json({f.interval->low, f.interval->high}) : Report::Json();
  if (f.sample) json["sample"] = *f.sample;
  return json;
}

std::size_t width_of_names(const Report& report)
{
  std::size_t width = 0;
  for (const Table& table : report.tables) {
    width = (std::max)(width, table.title.size());
    for (const Figure& f : table.figures) width = (std::max)(width, f.name.size() + 2);
  }
  return width;
}

} // namespace

std::string text_of(const Report& report)
{
  std::ostringstream os;
  os.imbue(std::locale::classic());
  const int names = int(width_of_names(report)), number = 9, interval = 19;
  os << report.title << '\n';
  for (const Table& table : report.tables) {
    os << '\n'
       << std::left << std::setw(names) << table.title << std::right << std::setw(number) << "value"
       << std::setw(interval) << "95 % interval" << std::setw(number) << "chance" << std::setw(number) << "sample"
       << '\n';
    for (const Figure& f : table.figures) {
      os << "  " << std::left << std::setw(names - 2) << f.name << std::right << std::setw(number) << cell(f.value);
      os << std::setw(interval)
         << (f.interval ? decimals(f.interval->low) + " to " + decimals(f.interval->high) : std::string("-"));
      os << std::setw(number) << cell(f.chance) << std::setw(number)
         << (f.sample ? std::to_string(*f.sample) : std::string("-")) << '\n';
    }
  }
  if (!report.remarks.empty()) os << '\n';
  for (const std::string& remark : report.remarks) os << remark << '\n';
  return os.str();
}

std::string json_text_of(const Report& report)
{
  Report::Json json = {{"format", "animated-mesh-features-evaluation"}, {"version", 1}};
  json.update(report.json);
  Report::Json& tables = json["figures"] = Report::Json::object();
  for (const Table& table : report.tables)
    for (const Figure& f : table.figures) tables[table.key][f.key] = json_of(f);
  return json.dump(1, ' ', false, Report::Json::error_handler_t::replace) + "\n";
}

} // namespace Evaluate_features
