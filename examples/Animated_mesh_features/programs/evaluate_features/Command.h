// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EVALUATE_FEATURES_COMMAND_H
#define EVALUATE_FEATURES_COMMAND_H

#include "evaluate_features/Report.h"
#include "options/Option_groups.h"
#include "plots/write_curves.h"

#include <CGAL/Animated_mesh_features/Evaluation/bootstrap_interval.h>
#include <CGAL/Animated_mesh_features/Evaluation/chance_level.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Evaluate_features {

// What all measures have in common.
struct Common_options
{
  bool help = false, quiet = false;
  std::string json, plot; // files; empty: none
  CGAL::Animated_mesh_features::Bootstrap_options bootstrap;
  CGAL::Animated_mesh_features::Chance_options chance;
};

// What a measure has found.
struct Result
{
  Report report;
  std::optional<Programs::Curves> curves; // what --plot draws
};

// A measure: one word of the command line, with options of its own.
class Command
{
public:
  virtual ~Command() = default;

  virtual std::string name() const = 0;
  virtual std::string summary() const = 0; // one line
  virtual std::string usage() const = 0;   // the arguments, after the name
  virtual std::string help() const = 0;    // what is measured, and how
  virtual bool has_curves() const = 0;

  // Options of its own; what is no option is appended to `inputs`.
  virtual void add_options(Programs::Option_groups& groups, std::vector<std::string>& inputs) = 0;

  // Looks at the inputs and options, before anything is read.
  // throws Option_error.
  virtual void check() = 0;

  // The files that are read and written, besides those of the common options.
  virtual std::vector<std::string> input_files() const = 0;
  virtual std::vector<std::string> output_files() const { return {}; }

  // Reads, measures, and writes files of its own.
  // throws Error.
  virtual Result run(const Common_options& common) = 0;
};

std::unique_ptr<Command> repeatability_command();
std::unique_ptr<Command> matching_error_command();
std::unique_ptr<Command> regions_command();
std::unique_ptr<Command> rig_command();
std::unique_ptr<Command> fit_command();

} // namespace Evaluate_features

#endif // EVALUATE_FEATURES_COMMAND_H
