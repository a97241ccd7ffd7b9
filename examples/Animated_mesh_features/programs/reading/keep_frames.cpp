// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/keep_frames.h"

#include <CGAL/Animated_mesh_features/Animation/last_frame_repeats_first.h>
#include <CGAL/Animated_mesh_features/IO/file_format.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

namespace {

Values kept_columns(const Values& all, std::size_t first, std::size_t count)
{
  Values kept(all.number_of_rows(), count, all.memory());
  for (std::size_t v = 0; v < all.number_of_rows(); ++v) std::copy_n(all.row(v) + first, count, kept.row(v));
  return kept;
}

template <class T>
void keep_elements(std::vector<T>& elements, std::size_t first, std::size_t count)
{
  elements.erase(elements.begin() + std::ptrdiff_t(first + count), elements.end());
  elements.erase(elements.begin(), elements.begin() + std::ptrdiff_t(first));
}

// Frames [first, first + count).
void keep(std::size_t first, std::size_t count, AMF::IO::Animation_file_data<FT>& data)
{
  for (Values* coordinate : {&data.x, &data.y, &data.z}) *coordinate = kept_columns(*coordinate, first, count);
  if (!data.times.empty()) keep_elements(data.times, first, count);
  if (AMF::IO::is_mesh(AMF::IO::file_format_by_ending(data.sources.back()))) keep_elements(data.sources, first, count);
  data.frames = count;
}

} // namespace

void keep_frames(const Frame_range& range, AMF::IO::Animation_file_data<FT>& data)
{
  const std::size_t first = range.first, last = range.last.value_or(data.frames - 1), count = last - first + 1;
  if (first >= data.frames || last >= data.frames)
    throw AMF::Option_error("--frames " + range.text + ": there is no such frame; frames are 0 to " +
                            std::to_string(data.frames - 1));
  if (count == data.frames) return;
  data.notices.push_back("frames " + std::to_string(first) + " to " + std::to_string(last) + " of " +
                         std::to_string(data.frames) + (first > 0 ? "; frames and times count from the first of them" : ""));
  keep(first, count, data);
}

void leave_out_repeated_frame(AMF::IO::Animation_file_data<FT>& data)
{
  if (!AMF::last_frame_repeats_first(data.x, data.y, data.z)) return;
  keep(0, data.frames - 1, data);
  data.notices.push_back("--cyclic: the last frame repeats the first and is left out; the period is " +
                         std::to_string(data.frames) + " frames");
}

} // namespace Programs
