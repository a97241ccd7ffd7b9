// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_CLIP_SAMPLING_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_CLIP_SAMPLING_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <locale>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesModels

Which clip of an animated model is taken, and at which times.

The frames are equidistant, from the clip's first key to its last one, both included. By default their distance is that
of the keys themselves, the commonest one: animations that were recorded or baked get their own frames back. Where keys
are sparse, since the curves between them say the rest, it is divided by the smallest whole number that gives at least
`least_frames` frames and `least_frames_per_second`, so that keys are still met. At a rate of one's own, what is left
after the last whole frame is left out.

A file of a few bytes may have two keys that are a year apart: more than `most_unasked_frames` are not made unless a track
has as many keys, or whoever reads the file asks for them.
*/
struct Clip_sampling
{
  /// a rate below which nothing is recorded: that of film.
  static constexpr double least_frames_per_second = 24;

  /// as many as it takes for some temporal scales between a frame and a part of the duration.
  static constexpr std::size_t least_frames = 48;

  /// more than an hour at any usual rate.
  static constexpr std::size_t most_unasked_frames = 250000;

  /// as many as may be asked for: four days at 30 in a second. Beyond, a rate is a mistake.
  static constexpr std::size_t most_frames = 10000000;

  std::string clip;                        ///< name, or index from 0; several, joined by +; empty: the first clip
  std::optional<std::size_t> frames;       ///< how many; at least 2
  std::optional<double> frames_per_second; ///< if `frames` is not given

  /// after the last frame, play all but that one backwards: gestures are often stored as the way there only, and what
  /// merely grows to the end has no moment of its own.
  bool there_and_back = false;

  /// leave out frames that are broken, and bridge them in time; by default they are an error. See `check_frames()`.
  bool skip_bad_frames = false;

  /// which part of the model is taken, by the name of a node, with all nodes below it, or of a mesh, or NAME/P for the
  /// primitive `P` of one of these; or else a connected component by its number. Empty: all. See `taken_parts()`,
  /// `keep_component()`.
  std::string part;
};

/*!
\ingroup PkgAnimatedMeshFeaturesModels

the clips by name, for messages: `0 "Walk", 1 "Run"`.
*/
inline std::string clip_list(const std::vector<std::string>& names)
{
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i)
    list += (i > 0 ? ", " : "") + std::to_string(i) + " \"" + names[i] + "\"";
  return list;
}

/*!
\ingroup PkgAnimatedMeshFeaturesModels

the index of the clip that `wanted` names, or else counts; the first one if `wanted` is empty.

\param names of all clips.
\param wanted a name or a number.
\param file for messages.
\throw Input_error if there are no clips.
\throw Option_error if there is no such clip, or several of that name; the message lists all names.
*/
inline std::size_t find_clip(const std::vector<std::string>& names, const std::string& wanted, const std::string& file)
{
  if (names.empty()) throw Input_error(file + ": holds no animation");
  if (wanted.empty()) return 0;
  const std::size_t n = std::size_t(std::count(names.begin(), names.end(), wanted));
  if (n == 1) return std::size_t(std::find(names.begin(), names.end(), wanted) - names.begin());
  if (n > 1)
    throw Option_error(file + ": several clips are called \"" + wanted +
                       "\"; choose one by its number: " + clip_list(names));
  for (std::size_t i = 0; i < names.size(); ++i)
    if (std::to_string(i) == wanted) return i;
  throw Option_error(file + ": there is no clip \"" + wanted + "\"; clips are " + clip_list(names));
}

/*!
\ingroup PkgAnimatedMeshFeaturesModels

the indices of the clips that `wanted` names, several of them joined by `+`; a clip whose own name has a `+` is found by the
whole name first.

\throw Input_error, Option_error as `find_clip()`; Option_error if a clip is named twice.
*/
inline std::vector<std::size_t> find_clips(const std::vector<std::string>& names, const std::string& wanted,
                                           const std::string& file)
{
  const bool is_name = std::find(names.begin(), names.end(), wanted) != names.end();
  if (is_name || names.empty() || wanted.find('+') == std::string::npos) return {find_clip(names, wanted, file)};
  std::vector<std::size_t> clips;
  for (std::size_t first = 0, end; first <= wanted.size(); first = end + 1) {
    end = (std::min)(wanted.find('+', first), wanted.size());
    const std::string part = wanted.substr(first, end - first);
    if (part.empty())
      throw Option_error(file + ": \"" + wanted + "\" joins a clip with nothing; clips are " + clip_list(names));
    const std::size_t clip = find_clip(names, part, file);
    if (std::find(clips.begin(), clips.end(), clip) != clips.end())
      throw Option_error(file + ": \"" + wanted + "\" names the clip \"" + names[clip] + "\" twice");
    clips.push_back(clip);
  }
  return clips;
}

/*!
\ingroup PkgAnimatedMeshFeaturesModels

clips that are played together, as one: formats store what moves the bones and what changes the shape of one motion as two.

\throw Option_error if two of them change the same of a node, so that it is not clear what becomes of it.
*/
inline Keyframed_model::Clip joined_clip(const Keyframed_model& model, const std::vector<std::size_t>& clips,
                                         const std::string& file)
{
  Keyframed_model::Clip joined;
  std::map<std::pair<std::size_t, Keyframed_model::Path>, std::size_t> moved_by; // node and what of it: the clip
  for (std::size_t clip : clips) {
    joined.name += (clip == clips.front() ? "" : "+") + model.clips[clip].name;
    for (const Keyframed_model::Channel& channel : model.clips[clip].channels) {
      const std::size_t first = moved_by.emplace(std::make_pair(channel.node, channel.path), clip).first->second;
      if (first != clip)
        throw Option_error(file + ": the clips \"" + model.clips[first].name + "\" and \"" + model.clips[clip].name +
                           "\" do not go together, both move node " + std::to_string(channel.node));
      joined.channels.push_back(channel);
    }
  }
  return joined;
}

/*!
\ingroup PkgAnimatedMeshFeaturesModels

the names of a model's clips, in their order; may be empty or equal.
*/
inline std::vector<std::string> clip_names(const Keyframed_model& model)
{
  std::vector<std::string> names;
  for (const Keyframed_model::Clip& clip : model.clips) names.push_back(clip.name);
  return names;
}

namespace internal {

// The commonest distance of two keys of the same track; of several ones, the shortest. Tracks with the same times count
// once: exporters give each bone that rests a key at either end.
inline double commonest_step(const Keyframed_model::Clip& clip)
{
  std::set<std::vector<double>> different;
  for (const Keyframed_model::Channel& channel : clip.channels) different.insert(channel.track.times);
  std::vector<double> steps;
  for (const std::vector<double>& times : different)
    for (std::size_t k = 1; k < times.size(); ++k)
      if (times[k] > times[k - 1]) steps.push_back(times[k] - times[k - 1]);
  std::sort(steps.begin(), steps.end());
  // Times are in single precision: a step late in a clip is rounded more coarsely than an early one.
  const double tolerance = 0.01;
  double commonest = 0;
  std::size_t most = 0;
  for (std::size_t first = 0, last; first < steps.size(); first = last) {
    double sum = 0;
    for (last = first; last < steps.size() && steps[last] <= steps[first] * (1 + tolerance); ++last) sum += steps[last];
    if (last - first > most) {
      most = last - first;
      commonest = sum / double(most);
    }
  }
  return commonest;
}

// in words: 1.2e+08, without the decimals that std::to_string() has
inline std::string rounded(double x)
{
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os << x;
  return os.str();
}

// How many times the distance of two frames the clip lasts, where nobody says.
inline double unasked_intervals(const Keyframed_model::Clip& clip, double duration, const std::string& file)
{
  const double step = commonest_step(clip); // 0 if each track has a single key
  const double own = step > 0 ? (std::max)(1., std::round(duration / step)) : 1;
  // 23.976 frames in a second are as good as 24.
  const double least = (std::max)(double(Clip_sampling::least_frames - 1),
                                  std::floor(0.99 * duration * Clip_sampling::least_frames_per_second));
  const double intervals = own * std::ceil(least / own);
  std::size_t most = Clip_sampling::most_unasked_frames;
  for (const Keyframed_model::Channel& channel : clip.channels) most = (std::max)(most, channel.track.times.size());
  if (!(intervals < double(most)))
    throw Input_error(file + ": clip \"" + clip.name + "\" lasts " + rounded(duration) + " s and would have " +
                      rounded(intervals + 1) + " frames, many more than it has keys; choose how many or how often" +
                      " (command line: --frames, --fps)");
  return intervals;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesModels

where in the clip the frames are (s), see `Clip_sampling`. \f$O(K \log K)\f$ for `K` keys.

\throw Input_error if all keys of the clip are at one time, or it would have more than `most_unasked_frames`.
\throw Option_error if less than 2 frames are asked for, or a rate at which there are less; or more than `most_frames`.
*/
inline std::vector<double> frame_times(const Keyframed_model::Clip& clip, const Clip_sampling& sampling,
                                       const std::string& file)
{
  double first = 0, last = 0;
  bool is_empty = true;
  for (const Keyframed_model::Channel& channel : clip.channels) {
    if (channel.track.times.empty()) continue;
    first = is_empty ? channel.track.times.front() : (std::min)(first, channel.track.times.front());
    last = is_empty ? channel.track.times.back() : (std::max)(last, channel.track.times.back());
    is_empty = false;
  }
  const double duration = last - first;
  if (!(duration > 0)) throw Input_error(file + ": clip \"" + clip.name + "\" has no duration: it moves nothing");

  double intervals, step = 0; // 0: as the number of intervals gives it
  if (sampling.frames) {
    if (*sampling.frames < 2) throw Option_error("an animation needs at least 2 frames");
    intervals = double(*sampling.frames - 1);
  } else if (sampling.frames_per_second) {
    step = 1 / *sampling.frames_per_second;
    intervals = std::floor(duration / step * (1 + 1e-6)); // keys are in single precision
    if (intervals < 1)
      throw Option_error(file + ": clip \"" + clip.name + "\" is shorter than a frame, " + std::to_string(duration) +
                         " s");
  } else {
    intervals = internal::unasked_intervals(clip, duration, file);
  }
  if (!(intervals < double(Clip_sampling::most_frames)))
    throw Option_error(file + ": clip \"" + clip.name + "\" would have " + internal::rounded(intervals + 1) +
                       " frames; at most " + std::to_string(Clip_sampling::most_frames) + " are made");
  const std::size_t n = std::size_t(intervals);
  std::vector<double> times(n + 1);
  for (std::size_t i = 0; i <= n; ++i)
    times[i] = step > 0 ? first + step * double(i) : first + duration * double(i) / double(n);
  if (sampling.there_and_back)
    for (std::size_t i = n; i-- > 0;) times.push_back(times[i]);
  return times;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_CLIP_SAMPLING_H
