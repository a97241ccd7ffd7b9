// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Memory_plan.h"

#include <CGAL/Animated_mesh_features/Detection/Memory_estimate.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/Scratch_field_memory.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

namespace {

// In the units of --memory.
std::string amount(std::size_t bytes)
{
  const double megabytes = std::ldexp(double(bytes), -20);
  char text[32];
  if (megabytes < 10000)
    std::snprintf(text, sizeof(text), "%.0fM", std::ceil(megabytes));
  else
    std::snprintf(text, sizeof(text), "%.1fG", megabytes / 1024);
  return text;
}

} // namespace

Memory_plan::Memory_plan(std::optional<std::size_t> limit, std::string scratch_directory)
  : m_limit(limit)
  , m_scratch_directory(std::move(scratch_directory))
{}

AMF::Memory_estimate Memory_plan::with_fields(AMF::Memory_estimate estimate) const
{
  estimate.fields += m_extra_fields * estimate.level;
  return estimate;
}

void Memory_plan::plan_in_memory(const AMF::Memory_estimate& estimate)
{
  const std::size_t allowed = m_limit.value_or(m_available);
  m_level_memory = estimate.for_levels(allowed);
  m_report = "memory: about " + amount((std::max)(estimate.least(), (std::min)(estimate.most(), allowed))) +
             ", fields in memory";
}

void Memory_plan::refine(const AMF::Rest_shape& shape)
{
  if (m_is_in_memory) plan_in_memory(with_fields(AMF::estimated_memory(shape, m_frames, sizeof(double))));
}

std::shared_ptr<AMF::Field_memory> Memory_plan::decide(std::size_t number_of_vertices, std::size_t number_of_frames,
                                                       std::size_t fields)
{
  m_frames = number_of_frames;
  m_extra_fields = fields;
  const AMF::Memory_estimate estimate =
      with_fields(AMF::estimated_memory(number_of_vertices, number_of_frames, sizeof(double)));
  const std::size_t available = m_available = AMF::available_memory();
  const std::string size =
      std::to_string(number_of_vertices) + " vertices in " + std::to_string(number_of_frames) + " frames";
  m_is_in_memory = estimate.least() <= m_limit.value_or(available);
  if (m_is_in_memory) {
    plan_in_memory(estimate);
    return AMF::Field_memory::heap();
  }
  const std::string needed = size + " need about " + amount(estimate.least()) + " of memory, ";
  const std::string on_disk = amount(estimate.most() - estimate.fixed) + " of disk";
  // the fields need some room to come and go
  const std::size_t least_limit = estimate.fixed + estimate.level / 4;
  if (!m_limit)
    throw AMF::Error(needed + amount(available) + " are available; with --memory and at least " + amount(least_limit) +
                     " it is computed on a scratch directory (--scratch), which takes " + on_disk);
  if (*m_limit < least_limit)
    throw AMF::Error(needed + "and at least " + amount(least_limit) + " with all fields on a scratch directory; " +
                     "--memory allows " + amount(*m_limit));
  m_report = "memory: up to " + amount(*m_limit) + ", fields on " + m_scratch_directory + " (" + on_disk + ")";
  return std::make_shared<AMF::Scratch_field_memory>(m_scratch_directory, *m_limit);
}

} // namespace Programs
