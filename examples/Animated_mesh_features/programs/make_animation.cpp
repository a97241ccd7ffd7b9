// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes a generated animation: the rest shape as OBJ, the frames as PC2 point cache.

#include "generators/articulated_figure.h"
#include "generators/bending_cylinder.h"

#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/IO/write_obj.h>
#include <CGAL/Animated_mesh_features/IO/write_point_cache.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <string>

namespace po = boost::program_options;
namespace AMF = CGAL::Animated_mesh_features;
using namespace Animated_mesh_generators;

namespace {

enum Exit_code
{
  SUCCESS = 0,
  FAILURE = 1, // whatever the command line cannot help: out of memory, for instance
  BAD_COMMAND_LINE = 2,
  CANNOT_WRITE = 4
};

const char* const usage = R"(Usage: make_animation figure|cylinder [options] -o BASE

Writes BASE.obj, the rest shape, and BASE.pc2, a point cache of all frames.

  figure     a small animal with long ears and a long tail that runs on the spot
  cylinder   an upright cylinder that bends at two joints: fast at the upper one, slowly and for long at the middle one

The motion is the same, in seconds, whatever the number of vertices and the frame rate. A point cache does not tell its
frame rate: whoever reads it has to know.

)";

const char* const exit_codes =
    "\nExit codes: 0 success, 1 failure, 2 bad command line, 4 the files cannot be written.\n";

// Typing errors beyond these would fill the memory before they fail.
const std::int64_t most_vertices = 10000000;
const std::int64_t most_frames = 1000000;

struct Command_line
{
  bool help = false;
  std::string what, base;
  std::int64_t vertices = 0, frames = 0; // 0: not given
  double rate = 0;
};

po::options_description described_options(Command_line& c)
{
  po::options_description options("Options");
  auto add = options.add_options();
  add("vertices", po::value(&c.vertices)->value_name("N"),
      "roughly how many vertices (default: 9000 for the figure, 4394 for the cylinder)");
  add("frames", po::value(&c.frames)->value_name("F"),
      "how many frames (default: as many as show the whole motion, 1.6 s of the figure and 2 s of the cylinder)");
  add("fps", po::value(&c.rate)->value_name("R")->default_value(30, "30"), "frames in a second");
  add("output,o", po::value(&c.base)->value_name("BASE"), "where to write: BASE.obj and BASE.pc2");
  add("help,h", po::bool_switch(&c.help), "show this text");
  return options;
}

Command_line parse(int argc, char* argv[])
{
  Command_line c;
  po::options_description options = described_options(c);
  options.add_options()("what", po::value(&c.what));
  po::positional_options_description positional;
  positional.add("what", 1);
  // No abbreviations: a later option must not change what a script means.
  using namespace po::command_line_style;
  po::variables_map given;
  po::store(po::command_line_parser(argc, argv)
                .options(options)
                .positional(positional)
                .style(unix_style & ~allow_guessing)
                .run(),
            given);
  po::notify(given);
  if (c.help) return c;

  if (c.what != "figure" && c.what != "cylinder")
    throw AMF::Option_error(c.what.empty() ? "say what to make: figure or cylinder"
                                           : "cannot make \"" + c.what + "\", only figure or cylinder");
  if (c.base.empty()) throw AMF::Option_error("say where to write: -o BASE");
  if (given.count("vertices") && (c.vertices < 1 || c.vertices > most_vertices))
    throw AMF::Option_error("--vertices must be from 1 to " + std::to_string(most_vertices));
  if (given.count("frames") && (c.frames < 1 || c.frames > most_frames))
    throw AMF::Option_error("--frames must be from 1 to " + std::to_string(most_frames));
  if (!(c.rate > 0) || !std::isfinite(c.rate)) throw AMF::Option_error("--fps must be positive and finite");
  return c;
}

// The clock of the command line, with as many frames as the generator's own number lasts, if it does not tell.
template <class Options>
void set_frame_duration(const Command_line& c, Options& options)
{
  const double frames =
      c.frames > 0 ? double(c.frames) : std::round(double(options.number_of_frames) / options.frame_rate * c.rate);
  if (frames > double(most_frames)) throw AMF::Option_error("--fps makes more than a million frames");
  options.number_of_frames = std::size_t((std::max)(1., frames));
  options.frame_rate = c.rate;
}

Generated_animation generate(const Command_line& c)
{
  if (c.what == "figure") {
    Articulated_figure_options options;
    set_frame_duration(c, options);
    if (c.vertices > 0) options.number_of_vertices = std::size_t(c.vertices);
    return articulated_figure(options);
  }
  Bending_cylinder_options options;
  set_frame_duration(c, options);
  if (c.vertices > 0) options.vertices_around = vertices_around_for(std::size_t(c.vertices), options);
  return bending_cylinder(options);
}

AMF::IO::Indexed_mesh rest_shape(const Generated_animation& animation)
{
  AMF::IO::Indexed_mesh result;
  // Neither generator leaves gaps in the numbering.
  for (const auto& p : animation.mesh.points()) result.points.push_back({{p.x(), p.y(), p.z()}});
  for (const auto f : faces(animation.mesh)) {
    std::array<std::size_t, 3> triangle;
    std::size_t corner = 0;
    for (const auto v : vertices_around_face(halfedge(f, animation.mesh), animation.mesh)) triangle[corner++] = v;
    result.triangles.push_back(triangle);
  }
  return result;
}

void write(const Generated_animation& animation, const std::string& base)
{
  // Both are complete, down to the last byte, before either takes its place.
  AMF::IO::Output_file obj(base + ".obj"), pc2(base + ".pc2");
  AMF::IO::write_obj(obj.stream(), rest_shape(animation));
  obj.stream().flush();
  obj.check();
  AMF::IO::write_pc2(pc2.stream(), num_vertices(animation.mesh), animation.frames.size(),
                     [&](std::size_t f, float* xyz) {
                       for (const auto& p : animation.frames[f])
                         for (int i = 0; i < 3; ++i) *xyz++ = float(p[i]);
                     });
  pc2.stream().flush();
  pc2.check();
  obj.commit();
  pc2.commit();
}

} // namespace

int main(int argc, char* argv[])
{
  try {
    const Command_line command_line = parse(argc, argv);
    if (command_line.help) {
      Command_line ignored;
      std::cout << usage << described_options(ignored) << exit_codes;
      return SUCCESS;
    }
    const Generated_animation animation = generate(command_line);
    write(animation, command_line.base);
    std::cout << command_line.base << ".obj: " << num_vertices(animation.mesh) << " vertices, "
              << num_faces(animation.mesh) << " triangles\n"
              << command_line.base << ".pc2: " << animation.frames.size() << " frames, " << command_line.rate
              << " in a second" << std::endl;
    return SUCCESS;
  } catch (const po::error& e) {
    std::cerr << "make_animation: " << e.what() << "\nTry make_animation --help" << std::endl;
    return BAD_COMMAND_LINE;
  } catch (const AMF::Option_error& e) {
    std::cerr << "make_animation: " << e.what() << "\nTry make_animation --help" << std::endl;
    return BAD_COMMAND_LINE;
  } catch (const AMF::Output_error& e) {
    std::cerr << "make_animation: " << e.what() << std::endl;
    return CANNOT_WRITE;
  } catch (const std::exception& e) {
    std::cerr << "make_animation: " << e.what() << std::endl;
    return FAILURE;
  }
}
