// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/Command_line.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>

namespace po = boost::program_options;
using CGAL::Animated_mesh_features::Option_error;

namespace Detect_features {

namespace {

// The options as the user types them.
struct Text
{
  std::string fps, rest, preset, spatial_filter, temporal_filter, strain, curvature, balls, box_width, space_counts,
      time_counts, ball_radius, alpha, sigma_range, tau_range, threshold, absolute_threshold, threads, memory, scratch;
  std::string html, html_every, vtk, glb, plot, png, png_size, png_background, view, up;
  std::string clip, frames, faces, vertex_map; // of models
  std::vector<std::string> outputs, fields, picture_frames;
};

po::typed_value<std::string>* text(std::string& to, const char* name)
{
  return po::value(&to)->value_name(name);
}

po::typed_value<std::vector<std::string>>* texts(std::vector<std::string>& to, const char* name)
{
  return po::value(&to)->value_name(name)->composing();
}

po::options_description described_options(Command_line& c, Text& t)
{
  const unsigned line_length = 100, description_length = 64;
  const auto group = [&](const char* title) { return po::options_description(title, line_length, description_length); };
  po::options_description input = group("Input");
  auto add_input = input.add_options();
  add_input("fps", text(t.fps, "R"),
            "frames in a second (default: as the times in an MDD file tell; for a clip see --frames; 60 for HDF5, as D-FAUST "
            "has it; otherwise 30). A clip is sampled at this rate");
  add_input("clip", text(t.clip, "NAME"),
            "the clip of an animated model, or the sequence of an HDF5 file, by name, or by number from 0 (default: the "
            "first; --verbose lists them)");
  add_input("frames", text(t.frames, "N"),
            "equidistant frames to make of a clip, from its first to its last key (default: the keys' own rate, their "
            "commonest step, refined by a whole number where that gives less than 48 frames or 24 in a second)");
  add_input("there-and-back", po::bool_switch(&c.there_and_back),
            "play the clip to its end and back again: a gesture that is stored one way only grows to its end, and has no "
            "moment of its own that could be a feature");
  add_input("faces", text(t.faces, "NAME"), "the dataset of triangles in an HDF5 file (default: faces)");
  add_input("rest", text(t.rest, "SHAPE"),
            "the undeformed shape: a mesh FILE of the same connectivity, frame:N counted from 0, or average, the "
            "canonical shape of all frames (default: frame:0)");
  add_input("rescale-rest", po::bool_switch(&c.rescale_rest),
            "scale the rest FILE so that its median edge is as long as that of the frames");
  add_input("triangulate", po::bool_switch(&c.triangulate), "cut faces with more than three corners into triangles");

  po::options_description method = group("Method");
  auto add_method = method.add_options();
  add_method("preset", text(t.preset, "NAME"),
             "calibrated (default), or published: the paper's own choices, marked (p) below. What the other options "
             "choose replaces a single choice of the preset");
  add_method("strain", text(t.strain, "NAME"), "hencky (default), green-lagrange, stretch, largest-eigenvalue (p)");
  add_method("curvature", text(t.curvature, "NAME"),
             "density: of mean curvature (default); dihedral: mean of dihedral angles (p)");
  add_method("balls", text(t.balls, "NAME"),
             "geodesic balls for the curvature: heat method (heat, default), the same by CGAL's class on local patches "
             "(heat-patches, slow) or on the whole mesh (heat-global, very slow), or paths along edges (dijkstra)");
  add_method(
      "ball-radius", text(t.ball_radius, "R"),
      "length, or % of the diagonal (default: 4.5 % of the diameter of the rest shape, between 3 and 8 mean edge lengths)");
  add_method("alpha", text(t.alpha, "A"),
             "weight of the change of curvature against strain (default: 7); 0 leaves curvature out");
  add_method("spatial-filter", text(t.spatial_filter, "NAME"),
             "heat: diffusion (default); one-ring: averages over neighbours (p)");
  add_method("temporal-filter", text(t.temporal_filter, "NAME"), "gaussian (default), box (p)");
  add_method("box-width", text(t.box_width, "W"),
             "width of the temporal box in frames; preset published only (default: a sixth of the frames)");
  add_method("space-counts", text(t.space_counts, "K"),
             "search up to K passes of the spatial filter; preset published only (default: by the paper's formula, which "
             "grows with the square of diagonal by edge length, to thousands for a fine mesh)");
  add_method("time-counts", text(t.time_counts, "L"),
             "search up to L passes of the temporal filter; preset published only (default: by the paper's formula)");
  add_method("sigma-range", text(t.sigma_range, "MIN:MAX"),
             "the spatial scales, as lengths or % of the diagonal; either may be left out (default: 1.4 to 17.5 % of "
             "the diameter of the rest shape). Preset calibrated only");
  add_method("tau-range", text(t.tau_range, "MIN:MAX"),
             "the temporal scales in seconds; either may be left out (default: from one frame to a sixth of the "
             "duration). Preset calibrated only");

  po::options_description selection = group("Selection");
  auto add_selection = selection.add_options();
  add_selection("threshold", text(t.threshold, "T"),
                "least strength as a fraction of the strongest one, 0 to 1 (default: 0.2)");
  add_selection("absolute-threshold", text(t.absolute_threshold, "T"),
                "least strength (default: 0); the stricter one of the two thresholds decides");
  add_selection("no-suppression", po::bool_switch(&c.no_suppression), "keep features close to stronger ones (p)");

  po::options_description output = group("Output");
  auto add_output = output.add_options();
  add_output("output,o", texts(t.outputs, "FILE"),
             "where to write the features, repeatable: .json, .csv or .ply by its ending; json:FILE, csv:FILE or "
             "ply:FILE whatever its name; - for the standard output (default: JSON on the standard output, if no scene is "
             "written either)");
  add_output("write-field", texts(t.fields, "FIELD:FILE"),
             "also write strain, curvature (its absolute change from the rest shape) or deformation (strain + alpha "
             "times curvature) of all N vertices in all F frames, repeatable: a NumPy file (.npy), N x F, float32");
  add_output("html", text(t.html, "FILE"),
             "a page for the browser, with everything in it: the moving surface, coloured by the deformation (and the fields "
             "of --write-field), the features as spheres, a timeline and a table");
  add_output("html-every", text(t.html_every, "N"),
             "take every N-th frame into the page, 1 for all of them (default: as many as leave 8 million positions)");
  add_output("vtk", text(t.vtk, "DIR"),
             "a scene for ParaView: in the folder DIR, surface.pvd with strain, curvature and deformation, and "
             "features.pvd with the features, each in the frames in which it lives");
  add_output("glb", text(t.glb, "FILE"),
             "a scene for Blender and other viewers of glTF: the moving surface, coloured by its deformation, with the "
             "features as spheres that come and go");
  add_output("plot", text(t.plot, "FILE"),
             "a plot of the features over time, and of how many there are of which sigma and tau: .svg, .pdf or .png by its "
             "ending, SVG on the standard output");
  add_output("png", text(t.png, "FILE"),
             "a picture (PNG) of the surface, coloured by the deformation, with the features as spheres (radius sqrt(2) "
             "sigma; blue: long, red: short), in the frames that --frame tells (default: those of the strongest "
             "features, at most 6)");
  add_output("frame", texts(t.picture_frames, "N"),
             "a frame to be shown in the picture, counted from 0; repeatable: several are shown beside each other");
  add_output("png-size", text(t.png_size, "WxH"), "the size of the picture in pixels (default: 1600x1000)");
  add_output("png-background", text(t.png_background, "RRGGBB"),
             "its background, hexadecimal (default: ffffff, white)");
  add_output("view", text(t.view, "AZIMUTH,ELEVATION"),
             "where the picture is taken from, in degrees: around the vertical axis, counterclockwise seen from above, "
             "from +z if y points up and from +x if z does; above the horizon, -89 to 89 (default: obliquely from the "
             "side on which the body is widest, and more of the strong features are seen, slightly from above)");
  add_output("up", text(t.up, "AXIS"),
             "the axis that points up in the picture: x, y or z (default: y or z, on which the body stands)");
  add_output("vertex-map", text(t.vertex_map, "FILE"),
             "also write which vertices of the file, by part, the vertices of the results are made of (CSV); models for "
             "pictures split vertices at seams, and split ones are welded on reading");
  add_output("quiet,q", po::bool_switch(&c.quiet), "say nothing but errors");
  add_output("verbose,v", po::bool_switch(&c.verbose), "tell about the data, and the time and memory of each stage");

  po::options_description other = group("Other");
  auto add_other = other.add_options();
  add_other("threads", text(t.threads, "N"), "how many threads to use at most; the result is the same (default: all)");
  add_other("memory", text(t.memory, "SIZE"),
            "how much memory to use at most, such as 4G or 800M; what does not fit goes to files on the scratch directory, "
            "with the same result (default: what is available, and nothing on a disk)");
  add_other("scratch", text(t.scratch, "DIR"),
            "the scratch directory, on a disk (default: that of the environment variable TMPDIR, or /var/tmp)");
  add_other("help,h", po::bool_switch(&c.help), "show this text");
  add_other("version", po::bool_switch(&c.version), "show the version");

  po::options_description all;
  all.add(input).add(method).add(selection).add(output).add(other);
  return all;
}

double number(const std::string& option, const std::string& text)
{
  char* end = nullptr;
  const double x =
      text.empty() || std::isspace(static_cast<unsigned char>(text[0])) ? 0 : std::strtod(text.c_str(), &end);
  if (end == nullptr || *end != '\0' || !std::isfinite(x))
    throw Option_error(option + ": \"" + text + "\" is no number");
  return x;
}

double positive_number(const std::string& option, const std::string& text)
{
  const double x = number(option, text);
  if (!(x > 0)) throw Option_error(option + ": \"" + text + "\" is not positive");
  return x;
}

double non_negative_number(const std::string& option, const std::string& text)
{
  const double x = number(option, text);
  if (!(x >= 0)) throw Option_error(option + ": \"" + text + "\" is negative");
  return x;
}

std::size_t count(const std::string& option, const std::string& text)
{
  const std::size_t most_digits = 9;
  const bool digits = std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  if (text.empty() || !digits || text.size() > most_digits)
    throw Option_error(option + ": \"" + text + "\" is no number from 0 to 999999999");
  return std::size_t(std::strtoul(text.c_str(), nullptr, 10));
}

void parse(const std::string& option, const std::string& text, Length& length)
{
  length.is_percentage = !text.empty() && text.back() == '%';
  length.value = positive_number(option, length.is_percentage ? text.substr(0, text.size() - 1) : text);
}

void parse(const std::string& option, const std::string& text, double& seconds)
{
  seconds = positive_number(option, text);
}

template <class T>
Range<T> range(const std::string& option, const std::string& text)
{
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos || text.size() == 1 || text.find(':', colon + 1) != std::string::npos)
    throw Option_error(option + ": \"" + text + "\" is no range MIN:MAX, MIN: or :MAX");
  Range<T> r;
  r.text = text;
  const std::string min = text.substr(0, colon), max = text.substr(colon + 1);
  if (!min.empty()) parse(option, min, r.min.emplace());
  if (!max.empty()) parse(option, max, r.max.emplace());
  return r;
}

void set_preset(const std::string& preset, Command_line& c)
{
  if (!preset.empty()) c.preset = chosen<Preset>("--preset", preset);
  if (c.preset == Preset::CALIBRATED) return; // what Command_line starts with
  c.strain = Strain::LARGEST_EIGENVALUE;
  c.curvature = Curvature::DIHEDRAL;
  c.spatial_filter = Spatial_filter::ONE_RING;
  c.temporal_filter = Temporal_filter::BOX;
}

template <class Choice>
void override_choice(const std::string& option, const std::string& text, Choice& choice)
{
  if (!text.empty()) choice = chosen<Choice>(option, text);
}

std::optional<std::size_t> smoothing_counts(const std::string& option, const std::string& text, Preset preset)
{
  if (text.empty()) return std::nullopt;
  const std::size_t result = count(option, text);
  if (result < 3) throw Option_error(option + ": at least 3 are needed for an extremum between them");
  if (preset != Preset::PUBLISHED)
    throw Option_error(option + " goes with --preset published only; elsewhere the scales follow from their range");
  return result;
}

void set_method(const Text& t, Command_line& c)
{
  set_preset(t.preset, c);
  override_choice("--strain", t.strain, c.strain);
  override_choice("--curvature", t.curvature, c.curvature);
  override_choice("--balls", t.balls, c.balls);
  override_choice("--spatial-filter", t.spatial_filter, c.spatial_filter);
  override_choice("--temporal-filter", t.temporal_filter, c.temporal_filter);
  if (!t.alpha.empty()) c.alpha = non_negative_number("--alpha", t.alpha);
  if (!t.ball_radius.empty()) parse("--ball-radius", t.ball_radius, c.ball_radius.emplace());
  if (!t.sigma_range.empty()) c.sigma = range<Length>("--sigma-range", t.sigma_range);
  if (!t.tau_range.empty()) c.tau = range<double>("--tau-range", t.tau_range);
  if (c.preset == Preset::PUBLISHED && !(c.sigma.text.empty() && c.tau.text.empty()))
    throw Option_error(
        std::string(c.sigma.text.empty() ? "--tau-range" : "--sigma-range") +
        " does not go with --preset published: there, every smoothing count is a scale, up to counts that "
        "follow from the bounding box and the number of frames");
  if (!t.box_width.empty()) {
    c.box_width = count("--box-width", t.box_width);
    if (*c.box_width < 2) throw Option_error("--box-width: a box must be at least 2 frames wide to smooth anything");
    if (c.preset != Preset::PUBLISHED || c.temporal_filter != Temporal_filter::BOX)
      throw Option_error(
          "--box-width goes with the box filter of --preset published only; elsewhere the filters follow "
          "the scales");
  }
  c.space_counts = smoothing_counts("--space-counts", t.space_counts, c.preset);
  c.time_counts = smoothing_counts("--time-counts", t.time_counts, c.preset);
  if (!t.threshold.empty()) {
    c.threshold = non_negative_number("--threshold", t.threshold);
    if (*c.threshold > 1)
      throw Option_error("--threshold: \"" + t.threshold +
                         "\" is above 1; it is a fraction of the strongest response (see --absolute-threshold)");
  }
  if (!t.absolute_threshold.empty())
    c.absolute_threshold = non_negative_number("--absolute-threshold", t.absolute_threshold);
}

// Bytes: a number with K, M, G or T (of 1024) behind it, or none of them.
std::size_t memory_size(const std::string& option, const std::string& text)
{
  std::string digits = text;
  double unit = 1;
  const std::string units = "KMGT";
  const std::size_t power = text.empty() ? std::string::npos : units.find(char(std::toupper(text.back())));
  if (power != std::string::npos) {
    digits.pop_back();
    unit = std::ldexp(1., 10 * (int(power) + 1));
  }
  const double bytes = unit * positive_number(option, digits);
  if (!(bytes < std::ldexp(1., 62))) throw Option_error(option + ": \"" + text + "\" is too much");
  return std::size_t(bytes);
}

std::string default_scratch_directory()
{
  const char* const directory = std::getenv("TMPDIR");
  if (directory != nullptr && *directory != '\0') return directory;
  return std::filesystem::is_directory("/var/tmp") ? "/var/tmp" : std::filesystem::temp_directory_path().string();
}

void set_memory(const Text& t, Command_line& c)
{
  if (!t.memory.empty()) c.memory = memory_size("--memory", t.memory);
  if (!t.scratch.empty() && !c.memory) throw Option_error("--scratch goes with --memory, which says when to use it");
  c.scratch_directory = t.scratch.empty() ? default_scratch_directory() : t.scratch;
}

void set_rest(const std::string& rest, Command_line& c)
{
  const std::string frame = "frame:";
  if (!rest.empty()) c.rest = rest;
  if (c.rest.compare(0, frame.size(), frame) == 0)
    c.rest_frame = count("--rest frame:N", c.rest.substr(frame.size()));
  else if (c.rest != "average")
    c.rest_file = c.rest;
  if (c.rescale_rest && c.rest_file.empty())
    throw Option_error("--rescale-rest needs a rest shape from a file: --rest FILE");
}

// PREFIX:FILE, if the prefix is one of the names
template <class Kind>
std::optional<Requested_file<Kind>> prefixed_file(const std::string& text)
{
  for (const auto& n : names(Kind()))
    if (text.compare(0, n.first.size() + 1, n.first + ":") == 0)
      return Requested_file<Kind>{n.second, text.substr(n.first.size() + 1)};
  return std::nullopt;
}

Requested_file<Format> requested_output(const std::string& text)
{
  if (text == "-") return {Format::JSON, text};
  if (const auto forced = prefixed_file<Format>(text)) return *forced;
  std::string ending = std::filesystem::path(text).extension().string();
  for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
  for (const auto& n : names(Format()))
    if (ending == "." + n.first) return {n.second, text};
  throw Option_error("-o " + text + ": the format is not clear from the ending (.json, .csv, .ply); write -o json:" +
                     text + ", for instance");
}

Requested_file<Field> requested_field(const std::string& text)
{
  if (const auto field = prefixed_file<Field>(text)) return *field;
  throw Option_error("--write-field " + text + ": write strain:FILE, curvature:FILE or deformation:FILE");
}

void set_picture(const Text& t, Command_line& c)
{
  const auto check_goes_with_png = [&](const std::string& option, bool is_given) {
    if (is_given && t.png.empty()) throw Option_error(option + " goes with --png, the picture that it is about");
  };
  check_goes_with_png("--frame", !t.picture_frames.empty());
  check_goes_with_png("--png-size", !t.png_size.empty());
  check_goes_with_png("--png-background", !t.png_background.empty());
  check_goes_with_png("--view", !t.view.empty());
  check_goes_with_png("--up", !t.up.empty());
  for (const std::string& f : t.picture_frames) c.picture.frames.push_back(count("--frame", f));
  if (!t.png_size.empty()) {
    const std::size_t by = t.png_size.find('x');
    if (by == std::string::npos) throw Option_error("--png-size: \"" + t.png_size + "\" is no size such as 1600x1000");
    c.picture.width = count("--png-size", t.png_size.substr(0, by));
    c.picture.height = count("--png-size", t.png_size.substr(by + 1));
  }
  if (!t.png_background.empty()) {
    const std::string hex = t.png_background[0] == '#' ? t.png_background.substr(1) : t.png_background;
    if (hex.size() != 6 || hex.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos)
      throw Option_error("--png-background: \"" + t.png_background + "\" is no colour such as ffffff");
    for (std::size_t i = 0; i < 3; ++i)
      c.picture.background[i] = std::uint8_t(std::strtoul(hex.substr(2 * i, 2).c_str(), nullptr, 16));
  }
  if (!t.view.empty()) {
    const std::size_t comma = t.view.find(',');
    if (comma == std::string::npos)
      throw Option_error("--view: \"" + t.view + "\" is no pair of angles such as 30,10");
    c.picture.azimuth = number("--view", t.view.substr(0, comma));
    c.picture.elevation = number("--view", t.view.substr(comma + 1));
  }
  if (!t.up.empty()) {
    if (t.up != "x" && t.up != "y" && t.up != "z")
      throw Option_error("--up: there is no \"" + t.up + "\"; choose among x, y, z");
    c.picture.up_axis = t.up[0] - 'x';
  }
  Programs::check_picture_options(c.picture);
}

// Files that show the features on the surface; whoever asks for one does not ask for JSON on the standard output.
void set_scenes(const Text& t, Command_line& c)
{
  const auto add = [&](Scene_format format, const std::string& path) {
    if (!path.empty()) c.scenes.push_back({format, path});
  };
  add(Scene_format::HTML, t.html);
  add(Scene_format::VTK, t.vtk);
  add(Scene_format::GLB, t.glb);
  add(Scene_format::PLOT, t.plot);
  add(Scene_format::PNG, t.png);
#ifndef DETECT_FEATURES_WITH_PICTURES
  if (!t.png.empty() || !t.plot.empty())
    throw Option_error(std::string(t.png.empty() ? "--plot" : "--png") +
                       ": this program was built without pictures: cairo was missing, or switched off");
#endif
  if (!t.html_every.empty()) {
    if (t.html.empty()) throw Option_error("--html-every goes with --html, the page that it is about");
    c.html_frame_step = count("--html-every", t.html_every);
    if (c.html_frame_step == 0) throw Option_error("--html-every: at least 1, which takes all frames");
  }
  if (t.vtk == "-") throw Option_error("--vtk: a folder cannot go to the standard output");
}

void set_outputs(const Text& t, Command_line& c)
{
  for (const std::string& o : t.outputs) c.outputs.push_back(requested_output(o));
  if (c.outputs.empty() && c.scenes.empty()) c.outputs.push_back({Format::JSON, "-"});
  for (const std::string& f : t.fields) c.fields.push_back(requested_field(f));
  std::set<std::string> paths;
  const auto check = [&](const std::string& path) {
    if (path.empty()) throw Option_error("an output file has no name");
    if (paths.insert(path).second) return;
    throw Option_error(path == "-" ? std::string("only one output can go to the standard output")
                                   : "two outputs go to the same file, " + path);
  };
  for (const auto& o : c.outputs) check(o.path);
  for (const auto& f : c.fields) check(f.path);
  for (const auto& s : c.scenes) check(s.path);
  c.vertex_map = t.vertex_map;
  if (!c.vertex_map.empty()) check(c.vertex_map);
}

void store(int argc, const char* const* argv, Command_line& c, Text& t)
{
  po::options_description options = described_options(c, t);
  options.add_options()("inputs", po::value(&c.inputs));
  po::positional_options_description positional;
  positional.add("inputs", -1);
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
  for (const auto& g : given) {
    const std::string* const value = boost::any_cast<std::string>(&g.second.value());
    if (value != nullptr && value->empty()) throw Option_error("--" + g.first + ": the value is empty");
  }
}

} // namespace

bool Command_line::is_written(Field field) const
{
  return std::any_of(fields.begin(), fields.end(),
                     [&](const Requested_file<Field>& f) { return f.kind == field; });
}

bool Command_line::is_shown(Field field) const
{
  // All scenes with a surface colour it by the deformation, and offer the others if they are there anyway.
  bool has_surface = false, has_all_fields = false;
  for (const auto& s : scenes) {
    has_surface = has_surface || s.kind != Scene_format::PLOT;
    has_all_fields = has_all_fields || s.kind == Scene_format::VTK;
  }
  if (field == Field::DEFORMATION) return has_surface;
  // Who leaves the curvature out does not want to wait for it.
  if (field == Field::CURVATURE && alpha && *alpha == 0) has_all_fields = false;
  return has_all_fields || (has_surface && is_written(field));
}

std::size_t Command_line::extra_fields() const
{
  std::size_t n = 0;
  for (Field field : {Field::STRAIN, Field::CURVATURE, Field::DEFORMATION}) n += is_written(field) || is_shown(field);
  return n;
}

Command_line parse_command_line(int argc, const char* const* argv)
{
  Command_line c;
  Text t;
  try {
    store(argc, argv, c, t);
  } catch (const po::error& e) {
    throw Option_error(e.what());
  }
  if (c.help || c.version) return c;
  if (c.inputs.empty())
    throw Option_error("no input: give a mesh and a point cache, a folder, a mesh for each frame, or an animated model");
  if (c.quiet && c.verbose) throw Option_error("--quiet and --verbose exclude each other");
  if (!t.fps.empty()) c.frames_per_second = positive_number("--fps", t.fps);
  c.clip = t.clip;
  if (!t.frames.empty()) c.clip_frames = count("--frames", t.frames);
  c.faces_dataset = t.faces;
  if (!t.threads.empty()) c.threads = count("--threads", t.threads);
  set_memory(t, c);
  set_rest(t.rest, c);
  set_method(t, c);
  set_scenes(t, c);
  set_picture(t, c);
  set_outputs(t, c);
  return c;
}

std::string full_usage()
{
  Command_line ignored;
  Text t;
  std::ostringstream os;
  os << R"(Usage: detect_features [options] INPUT...

Finds spatio-temporal feature points on an animated mesh: where, when, how large and how long it deforms distinctively.

INPUT is one of
  MESH CACHE    a mesh (.obj, .off, .ply, .stl) and a point cache (.pc2, .mdd) with the positions of its vertices
  FOLDER        of meshes, one for each frame, in natural order: frame2.obj before frame10.obj
  MESH MESH...  the frames themselves, in natural order whatever order they are given in
  MODEL         an animated model: glTF 2.0 (.glb, .gltf) with skins, morph targets and moving nodes; FBX, Collada, X (.fbx,
                .dae, .x) as well as assimp can read them (best effort: compare with what you expect)
  SEQUENCE      an HDF5 file (.h5, .hdf5) as D-FAUST's: vertices x 3 x frames, and triangles x 3
All frames have the same connectivity, a manifold of triangles, possibly with border. Results count vertices and frames
from 0; lengths are in the unit of the input, times in seconds. "The diagonal" is that of the bounding box of the rest
shape.

Examples:
  detect_features walk.obj walk.pc2 --rest standing.obj -o features.json -o features.ply
  detect_features frames/ --fps 25 --sigma-range 1%:10% --tau-range :0.5 | python3 -m json.tool
  detect_features hand.glb --clip Fist --there-and-back -o features.json
  detect_features walk.obj walk.mdd --alpha 0 --write-field strain:strain.npy -o strain_features.csv
)" << described_options(ignored, t)
     << R"(
Exit codes: 0 success, 1 failure (out of memory, numerical), 2 wrong usage, 3 unusable input, 4 output cannot be written,
130 interrupted. A regular output file appears whole or not at all; pipes and devices are written directly.
)";
  return os.str();
}

} // namespace Detect_features
