// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "compare_animations/Command_line.h"

#include "compare_animations/Item.h"
#include "compare_animations/Settings.h"
#include "compare_animations/commands.h"
#include "compare_animations/write_matrix.h"
#include "options/Option_groups.h"
#include "output/Pair_page.h"
#include "output/check_outputs.h"
#include "plots/plot_format.h"
#include "running/Interruption.h"
#include "running/Thread_limit.h"
#include "running/counted.h"
#include "running/run_program.h"
#include "running/tell.h"

#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
using Programs::Argument;
using Programs::Option_group;
using Programs::Option_groups;

namespace Compare_animations {

namespace {

enum class Mode
{
  PAIR,
  MATRIX,
  QUERY,
  DESCRIBE
};

void set_plot([[maybe_unused]] const Argument& a, [[maybe_unused]] Settings& s)
{
#ifdef DETECT_FEATURES_WITH_PICTURES
  Programs::plot_format(a.option(), a.text());
  s.plot = a.text();
#else
  throw AMF::Option_error(a.option() + ": this program was built without pictures: cairo was missing, or switched off");
#endif
}

} // namespace

void add_comparison_options(Option_group& group, Settings& s)
{
  const auto weight = [&](const std::string& name, const std::string& text, double& value) {
    group.add(name, "X", text, [&value](const Argument& a) { value = a.non_negative_number(); });
  };
  group.add_switch(
      "cyclic", s.activity.is_cyclic,
      "the last frame is followed by the first: loops are compared as ways around, from whatever frame they "
      "begin. A last frame that repeats the first is left out. In a list, of one animation; a file of features "
      "tells it itself");
  group.add("rate", "R",
            "samples in a second by which animations are aligned, whatever their frame rates (default: 30)",
            [&](const Argument& a) { s.activity.sample_duration = 1 / a.positive_number(); });
  weight("place-weight", "how much the places of deformation count in the alignment (default: 3)",
         s.alignment.place_weight);
  weight("recurrence-weight", "and how much what was before and comes after (default: 0)",
         s.alignment.recurrence_weight);
  group.add("max-slope", "N", "how much faster one animation may run than the other (default: 3)",
            [&](const Argument& a) { s.alignment.max_slope = a.count(); });
  weight("end-weight", "from 0, the ends of the animations are open, to 1 (default: 1)", s.alignment.end_weight);
  weight("bend-weight", "what it costs that one animation is faster than the other (default: 0.02)",
         s.alignment.bend_weight);
  weight("distance-place-weight", "how much the places of deformation count in the distance (default: 0)",
         s.distance.alignment.place_weight);
  weight("distance-recurrence-weight", "and how much what was before and comes after (default: 1)",
         s.distance.alignment.recurrence_weight);
  weight("cycle-weight", "how much cycles count in the distance, from 0 to 1 (default: 0.1)", s.distance.cycle_weight);
  weight("variation-weight", "and how much how far the body moves, from 0 to 1 (default: 0.4)",
         s.distance.variation_weight);
  weight("duration-weight", "and how much durations, from 0 to 1 (default: 0.1)", s.distance.duration_weight);
  group.add("matched", "N", "how many of the strongest features of each are matched (default: 150)",
            [&](const Argument& a) { s.matching.top = a.count(); });
  group.add(
      "ratio", "X",
      "match only features of which the second nearest is less alike, by this factor; a cycle fails it (default: 1, "
      "all)",
      [&](const Argument& a) { s.matching.max_ratio = a.positive_number(); });
  group.add_switch("mutual", s.matching.mutual_nearest, "match only features of which each is the other's nearest");
  group.add("descriptor", "NAME", "rotation-free or oriented (default: rotation-free)", [&](const Argument& a) {
    if (a.text() != "oriented" && a.text() != "rotation-free") a.refuse("is neither rotation-free nor oriented");
    s.is_oriented = a.text() == "oriented";
  });
}

void check_comparison(const Settings& s)
{
  s.alignment.check();
  s.distance.check();
  s.matching.check();
  s.activity.check();
}

namespace {

void add_options(Option_groups& groups, Settings& s)
{
  Programs::add_reading_options(groups.add_group("Input"), s.reading, "all, in a collection: each of them");
  Detect_features::add_selection_options(groups.add_group("Detection"), s.method);
  add_comparison_options(groups.add_group("Comparison"), s);
  Option_group& check = groups.add_group("Check of two takes");
  check.add_switch("check", s.check, "exit with 1 if events differ by more than the tolerance");
  check.add("tolerance", "X", "an amplitude, in the unit of the deformation (default: 0)",
            [&](const Argument& a) { s.tolerance = a.non_negative_number(); });
  Option_group& output = groups.add_group("Output");
  output.add("output,o", "FILE", "write all that was found as JSON; - for the standard output, in place of the table",
             [&](const Argument& a) { s.json = a.text(); });
  output.add("plot", "FILE", "matrix: draw it and an embedding in the plane: .svg, .pdf or .png by the ending",
             [&](const Argument& a) { set_plot(a, s); });
  output.add("html", "FILE",
             "two animations: write a page that plays both, side by side, through the alignment, with matched features "
             "in one colour",
             [&](const Argument& a) {
               Programs::check_pair_page();
               s.html = a.text();
             });
  output.add("write-descriptors", "FILE.npy", "describe: write the descriptors as NumPy array, features x length",
             [&](const Argument& a) { s.descriptors = a.text(); });
  output.add("cache", "FOLDER",
             "keep what is computed of animations in this folder, and look there first; beside: next to each of them",
             [&](const Argument& a) { s.cache = a.text(); });
  Programs::add_message_options(output, s.run);
  Option_group& other = groups.add_group("Other");
  Programs::add_resource_options(other, s.run);
  other.add_switch("help,h", s.help, "show this text");
  groups.add_positional("inputs", s.words, -1);
}

std::string help_of(const Option_groups& groups)
{
  std::ostringstream os;
  os << overview() << R"(
An animation is a point cache (.pc2, .mdd), whose mesh is beside it and begins with the same name, or stands before a
comma: MESH,CACHE; an animated model; a folder with a mesh for each frame; or a file of features that detect_features
has written (.json), of which there is less to compare. A COLLECTION is a folder of these; a list (.txt) with one in
each line, as detect_features would be told to read it, with options; or a model with --clip all. What of a collection
cannot be read is told and left out, and the exit code is 3.

matching      pairs of features that show the same event, by what the deformation around them is like, where on the body
              they are, and whether the pairs agree in distances and times.
alignment     the map of time by which the deformation of A is most like that of B; its confidence is 0 if rearranged
              pieces of B fit as well.
distance      from 0, the same motion, to 1. The same for a body of another shape, another mesh and another frame rate,
              as far as the deformation is.
differences   events of one of them only, after the alignment, and events of other amplitudes.
)" << groups
     << R"(
Exit codes: 0 success, 1 failure, or events differ by more than the tolerance, 2 wrong usage, 3 unusable input, 4 output
cannot be written, 130 interrupted.
)";
  return os.str();
}

void check_words(Mode mode, const Settings& s)
{
  if (mode == Mode::PAIR && s.words.size() != 2)
    throw AMF::Option_error("two animations are compared, not " + std::to_string(s.words.size()) +
                            "; or begin with matrix, query or describe");
  if (mode == Mode::MATRIX && s.words.empty()) throw AMF::Option_error("matrix: no collection is named");
  if (mode == Mode::QUERY && s.words.size() < 2)
    throw AMF::Option_error("query: an animation and a collection are needed");
  if (mode == Mode::DESCRIBE && s.words.size() != 1) throw AMF::Option_error("describe: one animation is needed");
  if (s.reading.clip == "all" && (mode == Mode::PAIR || mode == Mode::DESCRIBE))
    throw AMF::Option_error("--clip all goes with collections");
  if (s.check && mode != Mode::PAIR) throw AMF::Option_error("--check goes with two animations");
  if (!s.plot.empty() && mode != Mode::MATRIX) throw AMF::Option_error("--plot goes with matrix");
  if (!s.html.empty() && mode != Mode::PAIR) throw AMF::Option_error("--html goes with two animations");
  if (!s.descriptors.empty() && mode != Mode::DESCRIBE)
    throw AMF::Option_error("--write-descriptors goes with describe");
}

Result found(Mode mode, const Settings& s, std::string& descriptors)
{
  switch (mode) {
  case Mode::PAIR:
    return compare_pair(s);
  case Mode::MATRIX:
    return compare_all(s);
  case Mode::QUERY:
    return rank(s);
  case Mode::DESCRIBE:
    break;
  }
  return describe(s, descriptors);
}

// All files are complete before any of them takes its place.
void write(const Result& result, const std::string& descriptors, const Settings& s)
{
  std::vector<std::unique_ptr<AMF::IO::Output_file>> files;
  const auto open = [&](const std::string& path) -> std::ostream& {
    files.push_back(std::make_unique<AMF::IO::Output_file>(path));
    return files.back()->stream();
  };
  if (!s.json.empty()) open(s.json) << result.json.dump(1, ' ', false, Json::error_handler_t::replace) << "\n";
#ifdef DETECT_FEATURES_WITH_PICTURES
  if (!s.plot.empty()) write_matrix(open(s.plot), *result.matrix, Programs::plot_format("--plot", s.plot));
#endif
  if (!s.html.empty()) open(s.html).write(result.page.data(), std::streamsize(result.page.size()));
  if (!s.descriptors.empty()) open(s.descriptors).write(descriptors.data(), std::streamsize(descriptors.size()));
  for (const auto& file : files) {
    file->stream().flush();
    file->check();
  }
  for (const auto& file : files) file->commit();
}

void run(Mode mode, Settings& s)
{
  check_words(mode, s);
  check(s.run);
  check(s.method);
  check_comparison(s);
  std::vector<std::string> outputs;
  for (const std::string& path : {s.json, s.plot, s.html, s.descriptors})
    if (!path.empty()) outputs.push_back(path);
  std::vector<Item> items;
  for (std::size_t i = 0; i < s.words.size(); ++i) { // lists and clips are looked at later
    std::error_code ignored;
    if (std::filesystem::is_regular_file(s.words[i], ignored)) items.push_back({"", s.words[i], {}});
  }
  Programs::check_outputs(outputs, paths(items));
  if (!s.cache.empty() && s.cache != "beside" && !std::filesystem::is_directory(s.cache))
    throw AMF::Option_error("--cache " + s.cache + ": there is no such folder");
  const Programs::Thread_limit thread_limit(s.run.threads);
  const Programs::Interruption interruption;
  std::string descriptors;
  const Result result = found(mode, s, descriptors);
  Programs::Interruption::check();
  write(result, descriptors, s);
  if (!s.run.quiet && s.json != "-" && s.plot != "-" && s.html != "-" && s.descriptors != "-")
    std::cout << Programs::terminal_text(result.text) << std::flush;
  if (result.broken > 0)
    throw AMF::Input_error(Programs::counted(result.broken, "animation was", "animations were") + " left out");
  if (!result.failure.empty()) throw std::runtime_error(result.failure);
}

} // namespace

std::string overview()
{
  return R"(compare_animations compares animations of whatever meshes: matched features, alignment in time, distances.

  compare_animations A B [options]                  two animations
  compare_animations A B --html FILE [options]      the same to look at, side by side in a browser
  compare_animations A B --check --tolerance T      two takes of a motion; exit code 1 if an event differs by more
  compare_animations matrix COLLECTION [options]    all pairs of a collection
  compare_animations query A COLLECTION [options]   what is most like A
  compare_animations describe A [options]           the features of an animation with their descriptors

All options, with their defaults: compare_animations --help
)";
}

void run_command_line(int argc, const char* const* argv)
{
  const std::string first = argv[1];
  if (first == "--version") {
    std::cout << Programs::version_line("compare_animations") << std::flush;
    return;
  }
  Mode mode = Mode::PAIR;
  if (first == "matrix") mode = Mode::MATRIX;
  if (first == "query") mode = Mode::QUERY;
  if (first == "describe") mode = Mode::DESCRIBE;
  const int skipped = mode == Mode::PAIR ? 0 : 1;
  Settings s;
  Option_groups groups;
  add_options(groups, s);
  groups.parse(argc - skipped, argv + skipped);
  if (s.help) {
    std::cout << help_of(groups) << std::flush;
    return;
  }
  groups.use();
  s.reading.is_cyclic = s.activity.is_cyclic;
  run(mode, s);
}

} // namespace Compare_animations
