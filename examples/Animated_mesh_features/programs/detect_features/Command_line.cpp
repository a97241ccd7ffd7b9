// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/Command_line.h"

#include "options/Option_groups.h"
#include "options/write_manual_page.h"
#include "output/check_outputs.h"
#include "output/clip_outputs.h"

#include <sstream>

using Programs::Option_group;
using Programs::Option_groups;

namespace Detect_features {

namespace {

const char* const examples = R"(  detect_features walk.obj walk.pc2 --html view.html
  detect_features walk.obj walk.pc2 -o features.json -o features.csv
  detect_features hand.glb --clip Fist --there-and-back -o features.json
  detect_features knight.glb --clip all -o results/ --html 'results/{clip}.html'
  detect_features frames/ --fps 25 --rest standing.obj --png features.png
  detect_features walk.obj walk.pc2 --sigma-range 1%:10% --tau-range :0.5 | python3 -m json.tool
  detect_features walk.obj walk.mdd --alpha 0 --write-field strain:strain.npy -o strain_features.csv
)";

const char* const exit_codes =
    R"(0 success, 1 failure (out of memory, numerical), 2 wrong usage, 3 unusable input, 4 output cannot be written,
130 interrupted. A regular output file appears whole or not at all; pipes and devices are written directly.
)";

// The options of all parts of the program, as the help text has them.
void add_options(Option_groups& groups, Command_line& c)
{
  add_reading_options(groups.add_group("Input"), c.reading,
                      "all: each of them by itself, with a table at the end; outputs are then folders, in which files are "
                      "called as clips, or have {clip} where the clip's name is to be: -o results/ --html "
                      "'results/{clip}.html'");
  add_method_options(groups.add_group("Method"), c.method);
  add_selection_options(groups.add_group("Selection"), c.method);
  Option_group& output = groups.add_group("Output");
  add_output_options(output, c.output);
  add_message_options(output, c.run);
  Option_group& other = groups.add_group("Other");
  add_resource_options(other, c.run);
  other.add_switch("help,h", c.help, "show this text");
  other.add_switch("version", c.version, "show the version");
  other.add_switch("man", c.manual_page, "show this text as a manual page: detect_features --man | man -l -");
  other.add("completion", "SHELL", "show what completes the options in bash, zsh or fish",
            [&](const Programs::Argument& a) { c.completion = a.choice<Programs::Shell>(); });
  groups.add_positional("inputs", c.reading.inputs, -1);
}

} // namespace

Command_line parse_command_line(int argc, const char* const* argv)
{
  Command_line c;
  Option_groups groups;
  add_options(groups, c);
  groups.parse(argc, argv);
  if (c.help || c.version || c.manual_page) return c;
  groups.use();
  if (c.completion) return c;
  check(c.reading);
  check(c.run);
  check(c.method);
  if (c.has_all_clips()) {
    Programs::check_picture_options(c.output.picture);
    Programs::check_clip_outputs(c.output);
  } else {
    complete(c.output);
    Programs::check_outputs(c.output.paths(), c.reading.paths());
  }
  c.reading.is_cyclic = c.method.is_cyclic;
  c.output.is_curvature_used = c.method.alpha.value_or(1) != 0;
  return c;
}

std::string full_usage()
{
  Command_line unused;
  Option_groups groups;
  add_options(groups, unused);
  std::ostringstream os;
  os << "Usage: detect_features [options] INPUT...\n\n"
     << "Finds spatio-temporal feature points on an animated mesh: where, when, how large and how long it deforms "
        "distinctively.\n\n"
     << Programs::input_help() << "\nExamples:\n"
     << examples << groups << "\nExit codes: " << exit_codes;
  return os.str();
}

std::string manual_page()
{
  Command_line unused;
  Option_groups groups;
  add_options(groups, unused);
  std::ostringstream os;
  write_manual_page(os,
                    {"detect_features",
                     ANIMATED_MESH_FEATURES_VERSION,
                     "where, when, how large and how long an animated mesh deforms distinctively",
                     "[options] INPUT...",
                     {{"Input", Programs::input_help()}, {"Examples", examples}, {"Exit codes", exit_codes}}},
                    groups);
  return os.str();
}

std::string completion(Programs::Shell shell)
{
  Command_line unused;
  Option_groups groups;
  add_options(groups, unused);
  std::ostringstream os;
  write_completion(os, shell, "detect_features", groups);
  return os.str();
}

} // namespace Detect_features
