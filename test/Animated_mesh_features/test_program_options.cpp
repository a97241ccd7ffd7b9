// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Options of the programs: how arguments are understood, groups of options that a program puts together, and what the
// parts of the programs make of them. The whole command line of each program is tested by a script.

#include "test_support.h"

#include "detect_features/Command_line.h"
#include "options/Argument.h"
#include "options/Length.h"
#include "options/Option_groups.h"
#include "options/Range.h"
#include "running/tell.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <sstream>
#include <string>
#include <vector>

using namespace test_support;
using namespace Programs;
using CGAL::Animated_mesh_features::Option_error;

namespace {

Argument argument(const std::string& text)
{
  return Argument("--it", text);
}

void test_numbers()
{
  CHECK(argument("-2.5e1").number() == -25);
  CHECK(argument("0").non_negative_number() == 0);
  CHECK(argument("007").count() == 7);
  for (const char* text : {"", " 1", "1 ", "1,5", "nan", "inf", "1e999", "x"})
    CHECK_THROWS(Option_error, argument(text).number(), "--it: \"" + std::string(text) + "\" is no number");
  CHECK_THROWS(Option_error, argument("0").positive_number(), "not positive");
  CHECK_THROWS(Option_error, argument("-1").non_negative_number(), "negative");
  for (const char* text : {"", "-1", "1.5", "1234567890"})
    CHECK_THROWS(Option_error, argument(text).count(), "no number from 0 to 999999999");
}

void test_sizes()
{
  CHECK(argument("1000").bytes() == 1000);
  CHECK(argument("1.5k").bytes() == 1536);
  CHECK(argument("2G").bytes() == std::size_t(2) << 30);
  CHECK_THROWS(Option_error, argument("G").bytes(), "no number");
  CHECK_THROWS(Option_error, argument("9999999T").bytes(), "\"9999999T\" is too much");
}

void test_lengths_and_ranges()
{
  CHECK(length(argument("3")).on(10) == 3);
  CHECK_NEAR(length(argument("3%")).on(10), 0.3, 1e-15);
  CHECK_THROWS(Option_error, length(argument("%")), "no number");

  const auto seconds = [](const Argument& a) { return a.positive_number(); };
  const Range<double> both = range(argument("1:2"), seconds), above = range(argument("1:"), seconds);
  CHECK(both.text == "1:2" && *both.min == 1 && *both.max == 2);
  CHECK(*above.min == 1 && !above.max);
  CHECK(range(argument(":5%"), length).max->is_percentage);
  for (const char* text : {":", "1", "1:2:3"}) CHECK_THROWS(Option_error, range(argument(text), seconds), "MIN:MAX");
  CHECK_THROWS(Option_error, range(argument("0:1"), seconds), "not positive");
}

// Names come from files, and may be anything.
void test_terminal_text()
{
  const std::string box = "\xef\xbf\xbd";
  CHECK(terminal_text("").empty() && terminal_text("\n\n") == "\n\n" &&
        terminal_text("caf\xc3\xa9\nb") == "caf\xc3\xa9\nb");
  CHECK(terminal_text("a\x1b[31mRED\a\tb\n") == "a" + box + "[31mRED" + box + box + "b\n");
  const std::string line = "begin" + std::string(100000, 'x') + "end", shown = terminal_text(line + "\nnext");
  CHECK(shown.size() < 4100 && shown.compare(0, 6, "beginx") == 0 && shown.find("xend\nnext") != std::string::npos);
  CHECK(terminal_text(std::string(4000, 'x')) == std::string(4000, 'x'));
}

// A program of two parts, which writes down in which order its arguments are used.
struct Program
{
  Option_groups groups;
  bool loud = false;
  std::vector<std::string> used, inputs;

  Program()
  {
    const auto use = [&](const Argument& a) { used.push_back(a.option() + "=" + a.text()); };
    Option_group& first = groups.add_group("First");
    first.add("base", "B", "is used first", use);
    first.add_repeatable("also,a", "A", "in their order", use);
    Option_group& second = groups.add_group("Second");
    second.add("change", "C", "is used last", use);
    second.add_switch("loud", loud, "has no value");
    groups.add_positional("inputs", inputs, 2);
  }

  void run(std::vector<const char*> arguments)
  {
    arguments.insert(arguments.begin(), "program");
    groups.parse(int(arguments.size()), arguments.data());
    groups.use();
  }
};

void test_groups()
{
  Program p;
  p.run({"one", "--change=c", "-a", "y", "--loud", "--base", "b", "--also", "x", "two"});
  CHECK((p.used == std::vector<std::string>{"--base=b", "--also=y", "--also=x", "--change=c"}));
  CHECK((p.inputs == std::vector<std::string>{"one", "two"}));
  CHECK(p.loud);

  Program nothing;
  nothing.run({});
  CHECK(nothing.used.empty() && nothing.inputs.empty() && !nothing.loud);

  CHECK_THROWS(Option_error, Program().run({"--nothing"}), "--nothing");
  CHECK_THROWS(Option_error, Program().run({"--chang", "c"}), "--chang");
  CHECK_THROWS(Option_error, Program().run({"--base"}), "--base");
  CHECK_THROWS(Option_error, Program().run({"--base", "1", "--base", "2"}), "--base");
  CHECK_THROWS(Option_error, Program().run({"--base", ""}), "--base: the value is empty");
  CHECK_THROWS(Option_error, Program().run({"1", "2", "3"}), "positional");

  std::ostringstream help;
  help << p.groups;
  const std::string text = help.str();
  CHECK(text.find("First:") < text.find("--base B") && text.find("--base B") < text.find("Second:"));
  CHECK(text.find("-a [ --also ] A") != std::string::npos && text.find("inputs") == std::string::npos);
}

Detect_features::Command_line parsed(std::vector<const char*> arguments)
{
  arguments.insert(arguments.begin(), {"detect_features", "walk.glb"});
  return Detect_features::parse_command_line(int(arguments.size()), arguments.data());
}

void test_method()
{
  using namespace Detect_features;
  // a preset comes first, wherever it is typed
  const Method_options o = parsed({"--strain", "stretch", "--preset", "published"}).method;
  CHECK(o.preset == Preset::PUBLISHED && o.strain == Strain::STRETCH && o.curvature == Curvature::DIHEDRAL);
  CHECK(o.spatial_filter == Spatial_filter::ONE_RING && o.temporal_filter == Temporal_filter::BOX);
  CHECK(*parsed({"--space-counts", "5", "--preset", "published"}).method.space_counts == 5);
}

void test_reading()
{
  CHECK(parsed({}).reading.rest.kind == Rest::BY_INPUT);
  const Rest_choice frame = parsed({"--rest", "frame:7"}).reading.rest;
  CHECK(frame.kind == Rest::FRAME && frame.frame == 7);
  const Rest_choice first = parsed({"--rest", "first"}).reading.rest;
  CHECK(first.kind == Rest::FRAME && first.frame == 0);
  CHECK(parsed({"--rest", "average"}).reading.rest.kind == Rest::AVERAGE);
  CHECK(parsed({"--rest", "mesh"}).reading.rest.kind == Rest::MESH);
  const Rest_choice bind = parsed({"--rescale-rest", "--rest", "bind"}).reading.rest;
  CHECK(bind.kind == Rest::BIND && bind.file.empty() && bind.rescale);
  const Rest_choice file = parsed({"--rest", "standing.obj", "--rescale-rest"}).reading.rest;
  CHECK(file.kind == Rest::FILE && file.file == "standing.obj" && file.rescale);
}

void test_fields()
{
  const auto shown = [](const std::vector<const char*>& arguments) {
    const Output_options o = parsed(arguments).output;
    return int(o.is_shown(Field::STRAIN)) + 2 * int(o.is_shown(Field::CURVATURE)) +
           4 * int(o.is_shown(Field::DEFORMATION));
  };
  CHECK(shown({}) == 0);
  CHECK(shown({"--glb", "x.glb"}) == 4);
  CHECK(shown({"--glb", "x.glb", "--write-field", "strain:x.npy"}) == 5);
  CHECK(shown({"--vtk", "x"}) == 7);
  // nobody waits for a curvature that takes no part
  CHECK(shown({"--vtk", "x", "--alpha", "0"}) == 5);
  CHECK(shown({"--vtk", "x", "--alpha", "0", "--write-field", "curvature:x.npy"}) == 7);
  CHECK(parsed({"--vtk", "x"}).output.extra_fields() == 3);
  CHECK(parsed({"--write-field", "curvature:x.npy"}).output.extra_fields() == 1);

  // JSON goes to the standard output if nothing is asked for
  CHECK(parsed({}).output.features.front().path == "-");
  CHECK(parsed({"--glb", "x.glb"}).output.features.empty());
}

} // namespace

int main()
{
  test_numbers();
  test_sizes();
  test_lengths_and_ranges();
  test_terminal_text();
  test_groups();
  test_method();
  test_reading();
  test_fields();
  return test_result();
}
