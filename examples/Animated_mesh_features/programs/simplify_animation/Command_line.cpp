// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "simplify_animation/Command_line.h"

#include "options/Option_groups.h"
#ifdef DETECT_FEATURES_WITH_PICTURES
  #include "plots/plot_format.h"
#endif

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cmath>
#include <sstream>

using CGAL::Animated_mesh_features::Option_error;
using CGAL::Animated_mesh_features::Simplification_options;
using Programs::Argument;
using Programs::Option_group;
using Programs::Option_groups;

namespace Simplify_animation {

Programs::Names<Form> names(Form)
{
  return {{"obj", Form::OBJ}, {"ply", Form::PLY}, {"glb", Form::GLB}};
}

namespace {

// what is between commas
template <class Use>
void for_each_part(const Argument& a, const Use& use)
{
  std::size_t begin = 0;
  while (true) {
    const std::size_t comma = a.text().find(',', begin);
    use(a.part(begin, comma == std::string::npos ? comma : comma - begin));
    if (comma == std::string::npos) return;
    begin = comma + 1;
  }
}

double ratio(const Argument& a)
{
  const double r = a.positive_number();
  if (r > 1) a.refuse("is more than 1, all of the vertices");
  return r;
}

void set_plot([[maybe_unused]] const Argument& a, [[maybe_unused]] Command_line& o)
{
#ifdef DETECT_FEATURES_WITH_PICTURES
  Programs::plot_format(a.option(), a.text());
  o.plot = a.text();
#else
  throw Option_error(a.option() + ": this program was built without pictures: cairo was missing, or switched off");
#endif
}

} // namespace

void add_target_options(Option_group& target, Command_line& o)
{
  target.add("vertices", "N,...", "so many vertices; several numbers are levels of detail, from fine to coarse",
             [&](const Argument& a) { for_each_part(a, [&](const Argument& p) { o.vertices.push_back(p.count()); }); });
  target.add("ratio", "R", "this share of the vertices, up to 1",
             [&](const Argument& a) { o.ratios.assign(1, ratio(a)); });
  target.add("lods", "R,...", "levels of detail, nested: these shares of the vertices, such as 0.5,0.25,0.1",
             [&](const Argument& a) {
               if (!o.ratios.empty()) throw Option_error("--ratio and --lods exclude each other");
               for_each_part(a, [&](const Argument& p) { o.ratios.push_back(ratio(p)); });
             });
  target.add(
      "error", "E",
      "as few vertices as keep the mean distance, both ways, below E % of the diagonal of the rest shape in every "
      "frame; found within 10 % of their number",
      [&](const Argument& a) { o.error = a.positive_number(); });
}

Simplification_options simplification_options(const Command_line& o)
{
  Simplification_options result = o.method;
  if (o.error) result.refinements = 1; // levels are many, and each is near the one before
  result.refinements = o.refinements.value_or(result.refinements);
  return result;
}

void check_target(const Command_line& o)
{
  const int targets = int(!o.vertices.empty()) + int(!o.ratios.empty()) + int(o.error.has_value());
  if (targets != 1)
    throw Option_error("say how much is to be left, in one way: --vertices, --ratio, --lods or --error");
}

void add_simplification_options(Option_group& method, Command_line& o)
{
  method.add("poses", "N", "the most poses whose quadrics are summed (default: 32)", [&](const Argument& a) {
    o.method.poses = a.count();
    if (o.method.poses == 0) a.refuse("is not positive");
  });
  method.add("features", "FILE",
             "features of the animation (JSON, of detect_features): the report tells them from elsewhere",
             [&](const Argument& a) { o.features = a.text(); });
  method.add("guidance", "S",
             "with --features: how much more a feature's region counts while the feature lasts (default: 0, no more)",
             [&](const Argument& a) { o.strength = a.non_negative_number(); });
  method.add("normals", "DEGREES",
             "the most by which a collapse may turn a normal in any frame, below 90 (default: 78.5)",
             [&](const Argument& a) {
               const double angle = a.positive_number();
               if (angle >= 90 || angle < 3) a.refuse("is not from 3 to 90 degrees");
               o.method.least_cosine = std::cos(angle * 3.14159265358979 / 180);
             });
  method.add("support", "K", "the most vertices of the original that one vertex follows, up to 64 (default: 8)",
             [&](const Argument& a) {
               o.method.support = a.count();
               if (o.method.support == 0 || o.method.support > 64) a.refuse("is not from 1 to 64");
             });
  method.add("refinements", "N",
             "how often the places of a level's vertices are refined by the distances between both surfaces "
             "(default: 6, with --error 1)",
             [&](const Argument& a) { o.refinements = a.count(); });
  method.add_switch(
      "keep-seams", o.keep_seams,
      "of a model in glTF: leave alone the vertices along which its texture is cut; a GLB then has texture "
      "coordinates");
}

namespace {

void add_options(Option_groups& groups, Command_line& o)
{
  o.reading.denoise = Programs::Denoise::NEVER; // what is to be simplified is what was given
  Programs::add_reading_options(groups.add_group("Animation"), o.reading);
  add_target_options(groups.add_group("How much is left (one of them)"), o);
  add_simplification_options(groups.add_group("Method"), o);
  Option_group& output = groups.add_group("Output");
  output.add("output,o", "BASE", "write each level: BASE.obj and BASE.pc2, or BASE-1.obj, BASE-2.obj ... of several",
             [&](const Argument& a) { o.base = a.text(); });
  output.add(
      "format", "obj|ply|glb",
      "obj: rest shape and point cache; ply: a folder BASE with a mesh for each frame; glb: of a skinned model in "
      "glTF, BASE.glb with its skeleton and all of its clips, at most four joints a vertex, no materials "
      "(default: obj)",
      [&](const Argument& a) { o.form = a.choice<Form>(); });
  output.add_repeatable("also", "FILE",
                        "another animation of the same vertices, a point cache, repeatable: it follows without being "
                        "simplified; written as BASE_NAME.pc2",
                        [&](const Argument& a) { o.further.push_back(a.text()); });
  output.add("binding", "FILE", "write which vertices each vertex follows, and their weights (JSON)",
             [&](const Argument& a) { o.binding = a.text(); });
  output.add("report", "FILE",
             "write the errors of all levels in all frames as JSON; - for the standard output, in place of the table",
             [&](const Argument& a) { o.json = a.text(); });
  output.add("plot", "FILE", "draw the errors over the frames: .svg, .pdf or .png by the ending",
             [&](const Argument& a) { set_plot(a, o); });
  Option_group& other = groups.add_group("Other");
  other.add("threads", "N", "how many threads to use at most; the result is the same (default: all)",
            [&](const Argument& a) { o.running.threads = a.count(); });
  Programs::add_message_options(other, o.running);
  other.add_switch("version", o.version, "show the version");
  other.add_switch("help,h", o.help, "show this text");
  groups.add_positional("inputs", o.reading.inputs, -1);
}

void check(const Command_line& o)
{
  Programs::check(o.reading);
  Programs::check(o.running);
  check_target(o);
  if (o.strength && o.features.empty()) throw Option_error("--guidance goes with --features");
  if (o.base.empty() && o.json.empty() && o.plot.empty() && o.binding.empty())
    throw Option_error("say where to write: -o BASE, --report, --plot or --binding");
  if (!o.further.empty() && (o.base.empty() || o.form != Form::OBJ))
    throw Option_error("--also goes with -o BASE, and writes point caches");
}

} // namespace

Command_line parse_command_line(int argc, const char* const* argv)
{
  Command_line o;
  Option_groups groups;
  add_options(groups, o);
  groups.parse(argc, argv);
  if (o.help || o.version) return o;
  groups.use();
  check(o);
  return o;
}

std::string usage()
{
  Command_line unused;
  Option_groups groups;
  add_options(groups, unused);
  std::ostringstream os;
  os << "Usage: simplify_animation INPUT... --ratio R -o BASE [options]\n\n"
     << Programs::input_help() << R"(
Collapses edges of the mesh where that changes the surface least, in all poses together; no collapse turns a triangle over
in any frame. Every vertex that is left follows a few vertices of the original by weights, in every frame.

The table, the report and the plot tell how far each level is from the original: mean distances both ways, their worst
frame, and the Hausdorff distance of samples, in % of the diagonal of the rest shape's bounding box.
)" << groups
     << R"(
Exit codes: 0 success, 1 failure, 2 wrong usage, 3 unusable input, 4 output cannot be written, 130 interrupted.
)";
  return os.str();
}

} // namespace Simplify_animation
