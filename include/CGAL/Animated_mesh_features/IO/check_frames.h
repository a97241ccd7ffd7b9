// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_CHECK_FRAMES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_CHECK_FRAMES_H

#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/IO/file_format.h>
#include <CGAL/Animated_mesh_features/IO/internal/Frame_extents.h>
#include <CGAL/Animated_mesh_features/IO/internal/Frame_fault.h>
#include <CGAL/Animated_mesh_features/IO/internal/bridge_frames.h>
#include <CGAL/Animated_mesh_features/IO/internal/check_precision.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

// "3, 5-8", at most some of them
inline std::string frame_list(const std::vector<Bridged_frame>& frames)
{
  std::string list;
  std::size_t parts = 0;
  for (std::size_t i = 0, last; i < frames.size(); i = last + 1) {
    for (last = i; last + 1 < frames.size() && frames[last + 1].frame == frames[last].frame + 1;) ++last;
    if (++parts > 20) return list + " and others";
    list += (i > 0 ? ", " : "") + std::to_string(frames[i].frame) +
            (last > i ? "-" + std::to_string(frames[last].frame) : "");
  }
  return list;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesReading

looks at each frame of an animation that was read, whatever it was read from, for what cannot be true:
- it has no extent, as where a simulation or an export wrote zeros, or all its triangles are collapsed;
- a vertex is exploded: an edge is more than 10 times as long as the body is large, and does not grow with the
  others. The body is as large as its bounding box in the frame at the first quartile of sizes, so that three quarters of
  the frames may be broken. A body that grows or shrinks as a whole, and parts that fly away, are no fault.

Vertices in no triangle do not count. A single frame of the first kind between two good ones is bridged in time and
noted, since it holds nothing. Any other fault is an error, or with `skip_bad_frames` all bad frames are left out and
bridged: positions are interpolated linearly between the good frames on either side, so that numbers and times of frames
stay; before the first and after the last good one, that one is repeated.

Coordinates that are all of single precision, as point caches hold them, are rounded by 6e-8 of themselves: if that step
is more than 1 % of the mean edge, it is noted, if more than 10 %, it is an error that leaving out frames does not mend.

`O(N F)` time; memory for the edges of a frame, of some where vertices are exploded. The result does not depend on the
number of threads.

\param skip_bad_frames whether frames are left out rather than refused.
\param data an animation; its coordinates, the points of its mesh, if those are the first frame's, and its `notices` may
  change.
\throws Input_error if a frame is broken, and names it; if less than three frames are good; or the precision is too coarse.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class FT>
void check_frames(bool skip_bad_frames, Animation_file_data<FT>& data)
{
  if (data.mesh.triangles.empty() || data.frames == 0) return;
  const std::vector<internal::Frame_extent> extents = internal::frame_extents<ConcurrencyTag>(data);
  const std::size_t usual = internal::usual_frame(extents);
  if (usual == data.frames)
    throw Input_error(data.frame_name(0) + ": has no extent: all vertices are at one point, as in all other frames");
  const std::vector<internal::Frame_fault> faults = internal::frame_faults<ConcurrencyTag>(data, extents, usual);
  internal::check_precision(extents, faults, data);
  std::vector<char> is_good;
  for (const internal::Frame_fault& fault : faults) is_good.push_back(fault.kind == internal::Frame_fault::NONE);
  const std::size_t good = std::size_t(std::count(is_good.begin(), is_good.end(), 1));
  if (good == data.frames) return;
  const std::size_t first = std::size_t(std::find(is_good.begin(), is_good.end(), 0) - is_good.begin());
  const std::string what = data.frame_name(first) + ": " + faults[first].what;
  if (good < 3)
    throw Input_error(what + "; only " + std::to_string(good) + " of the " + std::to_string(data.frames) +
                      " frames are good");
  const std::vector<internal::Bridged_frame> bridged = internal::bridged_frames(is_good);
  const bool is_lone = bridged.size() == 1 && bridged[0].before != bridged[0].after && faults[first].holds_nothing();
  if (!skip_bad_frames && !is_lone)
    throw Input_error(what +
                      (bridged.size() == 1
                           ? std::string()
                           : "; broken are " + std::to_string(bridged.size()) + " of " + std::to_string(data.frames) +
                                 " frames: " + internal::frame_list(bridged)) +
                      "; leaving out bad frames (command line: --skip-bad-frames) bridges them in time");
  internal::bridge_frames<ConcurrencyTag>(bridged, data);
  if (!is_good[0] && !is_point_cache(file_format_by_ending(data.sources.back()))) // the mesh is the first frame
    for (std::size_t v = 0; v < data.mesh.points.size(); ++v) data.mesh.points[v] = internal::position(data, v, 0);
  data.notices.push_back(what + (bridged.size() == 1
                                     ? "; it is left out, bridged in time"
                                     : "; " + std::to_string(bridged.size()) +
                                           " frames are left out, bridged in time: " + internal::frame_list(bridged)));
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_CHECK_FRAMES_H
