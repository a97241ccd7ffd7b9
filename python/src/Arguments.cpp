// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Arguments.h"

#include "compare_animations/Command_line.h"
#include "options/Option_groups.h"

#include <sstream>

using namespace Programs;

namespace Python_module {

namespace {

void add(Option_groups& groups, Options& o, int taken)
{
  if (taken & READING) add_reading_options(groups.add_group("Input"), o.reading);
  if (taken & METHOD) {
    add_method_options(groups.add_group("Method"), o.method);
    add_selection_options(groups.add_group("Selection"), o.method);
  }
  if (taken & COMPARISON) add_comparison_options(groups.add_group("Comparison"), o.comparison);
  if (taken & SIMPLIFICATION) {
    add_target_options(groups.add_group("How much is left (one of them)"), o.simplification);
    add_simplification_options(groups.add_group("Simplification"), o.simplification);
  }
  if (taken & OUTPUT) add_output_options(groups.add_group("Output"), o.output);
  add_resource_options(groups.add_group("Resources"), o.run);
}

} // namespace

Options options_of(const Arguments& arguments, int taken)
{
  Options o;
  Option_groups groups;
  add(groups, o, taken);
  std::vector<const char*> argv = {"animated_mesh_features"};
  for (const std::string& a : arguments) argv.push_back(a.c_str());
  groups.parse(int(argv.size()), argv.data());
  groups.use();
  check(o.run);
  if (taken & METHOD) check(o.method);
  if (taken & COMPARISON) check_comparison(o.comparison);
  if (taken & SIMPLIFICATION) check_target(o.simplification);
  if (taken & OUTPUT) check_picture_options(o.output.picture);
  return o;
}

std::string help_of(int taken)
{
  Options unused;
  Option_groups groups;
  add(groups, unused, taken);
  std::ostringstream os;
  os << groups;
  return os.str();
}

} // namespace Python_module
