// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Reading_options.h"

#include "options/Option_groups.h"
#include "options/suggestion.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <filesystem>
#include <map>
#include <string>
#include <system_error>

namespace AMF = CGAL::Animated_mesh_features;
using AMF::Option_error;

namespace Programs {

namespace {

// A word without an ending that is no file was meant as one of the kinds.
void check_may_be_file(const Argument& argument)
{
  const std::filesystem::path path = argument.text();
  std::error_code ignored;
  if (path.has_extension() || path.has_parent_path() || std::filesystem::exists(path, ignored)) return;
  const std::map<std::string, std::string> others = {
      {"mean", "average"}, {"canonical", "average"}, {"last", "frame:N"}};
  const auto other = others.find(argument.text());
  argument.refuse("is neither a file nor mesh, bind, first, frame:N or average" +
                  (other != others.end() ? "; did you mean " + other->second + "?"
                                         : suggestion(argument.text(), {"mesh", "bind", "first", "frame:N", "average"})));
}

void set_rest(const Argument& argument, Rest_choice& rest)
{
  const std::string frame = "frame:";
  const bool rescale = rest.rescale;
  rest = Rest_choice();
  rest.rescale = rescale;
  rest.text = argument.text();
  if (rest.text.compare(0, frame.size(), frame) == 0) {
    rest.kind = Rest::FRAME;
    rest.frame = Argument("--rest frame:N", rest.text.substr(frame.size())).count();
    return;
  }
  const std::map<std::string, Rest> kinds = {
      {"first", Rest::FRAME}, {"mesh", Rest::MESH}, {"bind", Rest::BIND}, {"average", Rest::AVERAGE}};
  const auto found = kinds.find(rest.text);
  rest.kind = found == kinds.end() ? Rest::FILE : found->second;
  if (rest.kind == Rest::FILE) {
    check_may_be_file(argument);
    rest.file = rest.text;
  }
}

void set_frames(const Argument& argument, Reading_options& o)
{
  const std::size_t colon = argument.text().find(':');
  if (colon == std::string::npos) {
    o.clip_frames = argument.count();
    return;
  }
  Frame_range range;
  range.text = argument.text();
  if (colon > 0) range.first = argument.part(0, colon).count();
  if (colon + 1 < range.text.size()) range.last = argument.part(colon + 1).count();
  if (range.last && *range.last < range.first) argument.refuse("is empty: the first frame is after the last one");
  o.frame_range = range;
}

void add_clip_options(Option_group& group, Reading_options& o, const std::string& all_clips)
{
  group.add("clip", "NAME",
            "the clip of an animated model, or the sequence of an HDF5 file, by name, or by number from 0; several "
            "clips that play together as A+B (default: the first; --verbose lists them)" +
                (all_clips.empty() ? std::string() : "; " + all_clips),
            [&](const Argument& a) { o.clip = a.text(); });
  group.add_repeatable(
      "frames", "N|A:B",
      "N: equidistant frames to make of a clip, from its first to its last key (default: the keys' own rate, their "
      "commonest step, refined by a whole number where that gives less than 48 frames or 24 in a second). A:B: of "
      "whatever input, only the frames from A to B, which are counted from 0; either may be left out",
      [&](const Argument& a) { set_frames(a, o); });
  group.add_switch(
      "there-and-back", o.there_and_back,
      "play the clip to its end and back again: a gesture that is stored one way only grows to its end, and "
      "has no moment of its own that could be a feature");
  group.add_switch(
      "allow-outside", o.allow_outside,
      "read the data of a glTF model also where it names files outside of the model's folder: for models that "
      "you trust");
  group.add("faces", "NAME", "the dataset of triangles in an HDF5 file (default: faces)",
            [&](const Argument& a) { o.faces_dataset = a.text(); });
}

} // namespace

Names<Weld> names(Weld)
{
  return {{"auto", Weld::AUTO}, {"always", Weld::ALWAYS}, {"never", Weld::NEVER}};
}

Names<Denoise> names(Denoise)
{
  return {{"auto", Denoise::AUTO}, {"always", Denoise::ALWAYS}, {"never", Denoise::NEVER}};
}

void add_reading_options(Option_group& group, Reading_options& o, const std::string& all_clips)
{
  group.add(
      "fps", "R",
      "frames in a second (default: as the times in an MDD file tell; for a clip see --frames; 60 for HDF5, as D-FAUST "
      "has it; otherwise 30). A clip is sampled at this rate",
      [&](const Argument& a) {
        o.frames_per_second = a.positive_number();
        if (!is_usable_rate(*o.frames_per_second))
          throw Option_error("--fps " + a.text() +
                             ": no animation has that many frames in a second; from 1e-6 to 1e6 are taken");
      });
  add_clip_options(group, o, all_clips);
  group.add("part", "NAME|N",
            "take a part of the surface only: of a model a node, with all that hangs below it, or a mesh, by its name, or "
            "NAME/P for its primitive P; of an OBJ file an object or a group; of whatever input the N-th connected "
            "component, 1 for the one with the most vertices (--verbose lists all). Results count the part's own vertices "
            "and tell those of the file beside them",
            [&](const Argument& a) { o.part = a.text(); });
  group.add("rest", "SHAPE",
            "the undeformed shape: a mesh FILE of the same connectivity; mesh, the one given with a point cache; bind, a "
            "model without any clip; first, the first frame; frame:N, counted from 0; average, the canonical shape of "
            "all frames (default: mesh, unless it is one of the frames; bind, likewise; else average)",
            [&](const Argument& a) { set_rest(a, o.rest); });
  group.add_switch("rescale-rest", o.rest.rescale,
                   "scale the rest FILE, mesh or bind so that its median edge is as long as that of the frames");
  group.add_switch(
      "as-given", o.as_given,
      "take MESH MESH... as the frames in the order in which they are given, whatever numbers are in their "
      "names");
  group.add_switch("triangulate", o.triangulate, "cut faces with more than three corners into triangles");
  group.add(
      "weld", "WHEN",
      "what becomes of vertices of a mesh that lie at the same place in all frames: auto, they are welded where that "
      "closes a seam and makes a manifold; always, it is an error where it does not; never (default: auto)",
      [&](const Argument& a) { o.weld = chosen<Weld>(a.option(), a.text()); });
  group.add_switch(
      "repair", o.repair,
      "mend a mesh that is no oriented manifold: leave out collapsed and repeated faces, turn round what is "
      "oriented unlike its neighbours, take apart what meets in a vertex only, and tell each");
  group.add_switch(
      "skip-bad-frames", o.skip_bad_frames,
      "leave out frames that are broken, without extent or with a vertex that is exploded, and bridge them in time: "
      "numbers and times of frames stay. By default they are an error, but for a single frame without extent");
  group.add("denoise", "WHEN",
            "whether noise of the positions is taken out, as scans and captures have it, independent in vertices and "
            "frames: auto, where it is more than 10 % of the mean edge; always; never (default: " +
                name(o.denoise) + ")",
            [&](const Argument& a) { o.denoise = chosen<Denoise>(a.option(), a.text()); });
}

AMF::IO::Mesh_reading_options mesh_reading_options(const Reading_options& o)
{
  AMF::IO::Mesh_reading_options options;
  options.triangulate_faces = o.triangulate;
  options.frames_as_given = o.as_given;
  options.welding = o.weld == Weld::NEVER    ? AMF::IO::Welding::NEVER
                    : o.weld == Weld::ALWAYS ? AMF::IO::Welding::ALWAYS
                                             : AMF::IO::Welding::AUTO;
  options.repair = o.repair;
  options.skip_bad_frames = o.skip_bad_frames;
  options.part = o.part;
  return options;
}

std::vector<std::string> Reading_options::paths() const
{
  std::vector<std::string> all = inputs;
  if (!rest.file.empty()) all.push_back(rest.file);
  return all;
}

bool is_usable_rate(double frames_per_second)
{
  return frames_per_second >= 1e-6 && frames_per_second <= 1e6;
}

void check(const Reading_options& o)
{
  if (o.inputs.empty())
    throw Option_error(
        "no input: give a mesh and a point cache, a folder, a mesh for each frame, or an animated model");
  if (o.rest.rescale && o.rest.kind != Rest::FILE && o.rest.kind != Rest::MESH && o.rest.kind != Rest::BIND)
    throw Option_error("--rescale-rest needs a rest shape that may be in another unit: --rest FILE, mesh or bind");
}

std::string input_help()
{
  return R"(INPUT is one of
  MESH CACHE    a mesh (.obj, .off, .ply, .stl) and a point cache (.pc2, .mdd) with the positions of its vertices
  FOLDER        of meshes, one for each frame, in the order of their numbers: frame2.obj before frame10.obj; none missing
  MESH MESH...  the frames themselves, in the order of their numbers whatever order they are given in (but see --as-given)
  MODEL         an animated model: glTF 2.0 (.glb, .gltf) with skins, morph targets and moving nodes; FBX, Collada, X (.fbx,
                .dae, .x) as well as assimp can read them (best effort: compare with what you expect)
  SEQUENCE      an HDF5 file (.h5, .hdf5) as D-FAUST's: vertices x 3 x frames, and triangles x 3
All frames have the same connectivity, a manifold of triangles, possibly with border. Results count vertices and frames
from 0; lengths are in the unit of the input, times in seconds. The diameter is that of the
smallest sphere around what deforms of the rest shape.
)";
}

} // namespace Programs
