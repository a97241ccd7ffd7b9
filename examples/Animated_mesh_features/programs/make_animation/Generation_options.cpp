// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_animation/Generation_options.h"

#include "options/Names.h"
#include "options/Option_groups.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <sstream>

using CGAL::Animated_mesh_features::Option_error;
using Programs::Argument;
using Programs::Option_group;
using Programs::Option_groups;

namespace Make_animation {

namespace {

Programs::Names<Body> names(Body)
{
  return {{"figure", Body::FIGURE}, {"cylinder", Body::CYLINDER}};
}

std::size_t count_up_to(const Argument& a, std::size_t most)
{
  const std::size_t n = a.count();
  if (n < 1 || n > most) throw Option_error(a.option() + " must be from 1 to " + std::to_string(most));
  return n;
}

void add_options(Option_groups& groups, Generation_options& o, std::vector<std::string>& bodies)
{
  Option_group& group = groups.add_group("Options");
  group.add("vertices", "N", "roughly how many vertices (default: 9000 for the figure, 4394 for the cylinder)",
            [&](const Argument& a) { o.vertices = count_up_to(a, Generation_options::most_vertices); });
  group.add("frames", "F",
            "how many frames (default: as many as show the whole motion, 1.6 s of the figure and 2 s of the cylinder)",
            [&](const Argument& a) { o.frames = count_up_to(a, Generation_options::most_frames); });
  group.add("fps", "R", "frames in a second (default: 30)",
            [&](const Argument& a) { o.frames_per_second = a.positive_number(); });
  group.add("output,o", "BASE", "where to write: BASE.obj and BASE.pc2", [&](const Argument& a) { o.base = a.text(); });
  group.add("events", "FILE",
            "of the figure, also write which joint is bent most when, and which vertices that moves (JSON): what "
            "evaluate_features rig compares features with",
            [&](const Argument& a) { o.events = a.text(); });
  group.add_switch("help,h", o.help, "show this text");
  groups.add_positional("what", bodies, 1);
}

Body body(const std::vector<std::string>& bodies)
{
  if (bodies.empty()) throw Option_error("say what to make: figure or cylinder");
  for (const auto& n : names(Body()))
    if (n.first == bodies.front()) return n.second;
  throw Option_error("cannot make \"" + bodies.front() + "\", only figure or cylinder");
}

} // namespace

Generation_options parse_command_line(int argc, const char* const* argv)
{
  Generation_options o;
  std::vector<std::string> bodies;
  Option_groups groups;
  add_options(groups, o, bodies);
  groups.parse(argc, argv);
  if (o.help) return o;
  o.body = body(bodies);
  groups.use();
  if (o.base.empty()) throw Option_error("say where to write: -o BASE");
  if (!o.events.empty() && o.body != Body::FIGURE)
    throw Option_error("--events goes with the figure, which has joints");
  return o;
}

std::string usage()
{
  Generation_options unused;
  std::vector<std::string> bodies;
  Option_groups groups;
  add_options(groups, unused, bodies);
  std::ostringstream os;
  os << R"(Usage: make_animation figure|cylinder [options] -o BASE

Writes BASE.obj, the rest shape, and BASE.pc2, a point cache of all frames.

  figure     a small animal with long ears and a long tail that runs on the spot
  cylinder   an upright cylinder that bends at two joints: fast at the upper one, slowly and for long at the middle one

The motion is the same, in seconds, whatever the number of vertices and the frame rate. A point cache does not tell its
frame rate: whoever reads it has to know.

)" << groups
     << R"(
Exit codes: 0 success, 1 failure, 2 wrong usage, 4 the files cannot be written, 130 interrupted.
)";
  return os.str();
}

} // namespace Make_animation
