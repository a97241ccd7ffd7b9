// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "evaluate_features/Command_line.h"

#include "evaluate_features/Command.h"
#include "output/check_outputs.h"
#include "plots/plot_format.h"
#include "plots/write_curves.h"
#include "running/Interruption.h"
#include "running/run_program.h"
#include "running/tell.h"

#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
using Programs::Argument;
using Programs::Option_group;
using Programs::Option_groups;

namespace Evaluate_features {

namespace {

std::vector<std::unique_ptr<Command>> commands()
{
  std::vector<std::unique_ptr<Command>> all;
  all.push_back(repeatability_command());
  all.push_back(matching_error_command());
  all.push_back(regions_command());
  all.push_back(rig_command());
  all.push_back(fit_command());
  return all;
}

std::unique_ptr<Command> command(const std::string& name)
{
  std::string names;
  for (std::unique_ptr<Command>& c : commands()) {
    if (c->name() == name) return std::move(c);
    names += (names.empty() ? "" : ", ") + c->name();
  }
  throw AMF::Option_error("there is no measure \"" + name + "\"; choose among " + names);
}

void set_plot([[maybe_unused]] const Argument& a, [[maybe_unused]] Common_options& o)
{
#ifdef DETECT_FEATURES_WITH_PICTURES
  Programs::plot_format(a.option(), a.text());
  o.plot = a.text();
#else
  throw AMF::Option_error(a.option() + ": this program was built without pictures: cairo was missing, or switched off");
#endif
}

std::size_t positive_count(const Argument& a)
{
  if (a.count() == 0) a.refuse("is not positive");
  return a.count();
}

void add_common_options(Option_groups& groups, const Command& command, Common_options& o)
{
  Option_group& group = groups.add_group("All measures");
  group.add("output,o", "FILE", "write all figures as JSON; - for the standard output, in place of the table",
            [&](const Argument& a) { o.json = a.text(); });
  if (command.has_curves())
    group.add("plot", "FILE", "draw curves: .svg, .pdf or .png by the ending, SVG on the standard output",
              [&](const Argument& a) { set_plot(a, o); });
  group.add("draws", "N", "random draws for a chance level (default: 20)",
            [&](const Argument& a) { o.chance.draws = positive_count(a); });
  group.add("resamples", "N", "resamples for an interval (default: 1000)",
            [&](const Argument& a) { o.bootstrap.resamples = positive_count(a); });
  group.add("seed", "N", "of the random numbers; the same seed gives the same figures (default: 0)",
            [&](const Argument& a) { o.chance.seed = o.bootstrap.seed = a.count(); });
  group.add_switch("quiet,q", o.quiet, "print no table");
  group.add_switch("help,h", o.help, "show this text");
}

std::string help_of(const Command& command, const Option_groups& groups)
{
  std::ostringstream os;
  os << "Usage: evaluate_features " << command.name() << ' ' << command.usage() << "\n\n"
     << command.help() << '\n'
     << groups << R"(
Exit codes: 0 success, 1 failure, 2 wrong usage, 3 unusable input, 4 output cannot be written, 130 interrupted.
)";
  return os.str();
}

Report::Json json_of(const Programs::Curves& curves)
{
  Report::Json json = {{"x", curves.x_name}, {"y", curves.y_name}, {"of", Report::Json::array()}};
  for (const Programs::Curve& c : curves.curves)
    json["of"].push_back({{"name", c.name}, {"is_chance", c.is_chance}, {"x", c.x}, {"y", c.y}});
  return json;
}

// Both files are complete before either takes its place.
void write(const Result& result, const Common_options& o)
{
  std::optional<AMF::IO::Output_file> json, plot;
  if (!o.json.empty()) {
    json.emplace(o.json);
    json->stream() << json_text_of(result.report);
    json->stream().flush();
    json->check();
  }
#ifdef DETECT_FEATURES_WITH_PICTURES
  if (!o.plot.empty()) {
    plot.emplace(o.plot);
    write_curves(plot->stream(), *result.curves, Programs::plot_format("--plot", o.plot));
    plot->stream().flush();
    plot->check();
  }
#endif
  if (json) json->commit();
  if (plot) plot->commit();
}

void run(Command& command, const Common_options& o)
{
  command.check();
  std::vector<std::string> outputs = command.output_files();
  if (!o.json.empty()) outputs.push_back(o.json);
  if (!o.plot.empty()) outputs.push_back(o.plot);
  Programs::check_outputs(outputs, command.input_files());
  Result result = command.run(o);
  const Programs::Interruption interruption; // now that there is something to be left on a disk
  if (result.curves) result.report.json["curves"] = json_of(*result.curves);
  Programs::Interruption::check();
  write(result, o);
  if (!o.quiet && o.json != "-" && o.plot != "-")
    std::cout << Programs::terminal_text(text_of(result.report)) << std::flush;
}

} // namespace

std::string overview()
{
  std::string text =
      R"(evaluate_features measures how good features are: against another detection, against the events of a skeleton,
against what people painted, and against the field in which they were found.

)";
  for (const std::unique_ptr<Command>& c : commands())
    text += "  evaluate_features " + c->name() + ' ' + c->usage() + "\n      " + c->summary() + "\n";
  return text + "\nAll options, with their defaults: evaluate_features MEASURE --help\n";
}

void run_command_line(int argc, const char* const* argv)
{
  const std::string name = argv[1];
  if (name == "--help" || name == "-h") {
    std::cout << overview() << std::flush;
    return;
  }
  if (name == "--version") {
    std::cout << Programs::version_line("evaluate_features") << std::flush;
    return;
  }
  const std::unique_ptr<Command> chosen = command(name);
  Common_options common;
  std::vector<std::string> inputs;
  Option_groups groups;
  chosen->add_options(groups, inputs);
  add_common_options(groups, *chosen, common);
  groups.parse(argc - 1, argv + 1);
  if (common.help) {
    std::cout << help_of(*chosen, groups) << std::flush;
    return;
  }
  groups.use();
  run(*chosen, common);
}

} // namespace Evaluate_features
