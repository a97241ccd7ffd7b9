// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where fields live: what is computed from fields lives where they do, in memory of the user's own, too. Fields in scratch
// files: the same values as in memory, whatever is let go of; a detection on them has the same bits; errors of directories.

#include "test_recording_memory.h"
#include "test_shapes.h"
#include "test_support.h"
#include "test_two_stages.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Deformation/Deformation_measurement.h>
#include <CGAL/Animated_mesh_features/Deformation/curvature.h>
#include <CGAL/Animated_mesh_features/Deformation/deformation.h>
#include <CGAL/Animated_mesh_features/Deformation/strain.h>
#include <CGAL/Animated_mesh_features/Detection/Detection_options.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Animated_mesh_features/Detection/Memory_estimate.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/Scratch_field_memory.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "generators/bending_cylinder.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <thread>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;
using namespace test_support;

typedef Amf::Spatio_temporal_field<double> Field;

const char* const scratch_directory = "."; // the build tree is on a disk

bool is_zero(const Field& field)
{
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.stride(); ++f)
      if (field.row(v)[f] != 0) return false;
  return true;
}

void fill(Field& field, double factor)
{
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f) field(v, f) = factor * double(v) + double(f);
}

bool is_filled(const Field& field, double factor)
{
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f)
      if (field(v, f) != factor * double(v) + double(f)) return false;
  return true;
}

// What holds for a field wherever it lives.
void test_values(const std::shared_ptr<Amf::Field_memory>& memory)
{
  for (const std::size_t frames : {1, 7, 8, 60, 511, 512}) {
    Field field(37, frames, memory);
    CHECK(field.memory() == memory);
    CHECK(is_zero(field));
    CHECK(reinterpret_cast<std::uintptr_t>(field.row(0)) % 64 == 0);
    CHECK(reinterpret_cast<std::uintptr_t>(field.row(1)) % 64 == 0);
    CHECK(field.size_in_bytes() == Field::size_in_bytes(37, frames));
    fill(field, 3);
    Field copy = field, other(5, frames), same_size(37, frames);
    CHECK(copy.memory() == memory && other.memory() == Amf::Field_memory::heap());
    fill(field, 2);
    CHECK(is_filled(copy, 3));
    other = copy;
    same_size = copy;
    CHECK(is_filled(other, 3) && other.number_of_rows() == 37 && is_filled(same_size, 3));
    CHECK(other.memory() == memory && same_size.memory() == memory);
    const double* const values = other.row(0);
    Field moved = std::move(other);
    CHECK(moved.row(0) == values && is_filled(moved, 3));
    moved = std::move(field);
    CHECK(is_filled(moved, 2));
    moved.swap(copy);
    CHECK(is_filled(moved, 3) && is_filled(copy, 2));
    const Field& self = moved;
    moved = self;
    CHECK(is_filled(moved, 3));
  }
  const Field empty;
  const Field copy = empty;
  CHECK(copy.number_of_rows() == 0 && copy.size_in_bytes() == 0 && copy.memory() == nullptr);
}

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Amf::Spatio_temporal_feature<Mesh::Vertex_index> Feature;

Animated_mesh_generators::Generated_animation cylinder()
{
  Animated_mesh_generators::Bending_cylinder_options options;
  options.vertices_around = 14;
  options.number_of_frames = 30;
  options.frame_rate = 15;
  return Animated_mesh_generators::bending_cylinder(options);
}

std::vector<Feature> detected(std::size_t level_memory, const std::shared_ptr<Amf::Field_memory>& memory)
{
  const auto animation = cylinder();
  const Amf::Frame_sequence<Mesh> sequence(animation.mesh, animation.frames, animation.frame_duration, memory);
  Amf::Calibrated_options options;
  options.level_memory = level_memory;
  options.selection.absolute_threshold = 0;
  std::vector<Feature> features;
  CGAL::detect_spatio_temporal_features(sequence, std::back_inserter(features), options);
  return features;
}

// Whatever is computed from an animation in memory of the user's own lives there. Coordinates are of type float, levels of
// type double: blocks tell by their size what they are of.
void test_computed_fields()
{
  typedef Amf::Frame_sequence<Mesh, float> Sequence;
  typedef Amf::Spatio_temporal_field<float> Float_field;
  const auto animation = cylinder();
  const auto memory = std::make_shared<Recording_memory>();
  const std::size_t n = num_vertices(animation.mesh), frames = animation.frames.size();
  const std::size_t field = Float_field::size_in_bytes(n, frames), level = Field::size_in_bytes(n, frames);
  CHECK(field < level);
  {
    const Sequence sequence(animation.mesh, animation.frames, animation.frame_duration, memory);
    CHECK(sequence.trajectories().memory() == memory);
    CHECK(memory->allocations(field) == 3 && memory->allocations() == 3);

    const Amf::Compressed_rows balls = Amf::geodesic_balls(sequence.rest_shape());
    const Float_field strain = Amf::strain(sequence), change = Amf::curvature_change(sequence, balls);
    const Float_field sum = Amf::deformation(strain, change);
    CHECK(strain.memory() == memory && change.memory() == memory && sum.memory() == memory);
    CHECK(Amf::triangle_strain(sequence).memory() == memory);
    CHECK(Amf::curvature(sequence, balls).memory() == memory);
    CHECK(memory->in_use() == 3 + 3 && memory->allocations(level) == 0);

    Amf::Deformation_measurement<Sequence> measurement(sequence);
    CHECK(measurement.strain().memory() == memory && measurement.curvature_change().memory() == memory);
    CHECK(measurement.deformation().memory() == memory && memory->in_use() == 6 + 3);
    const std::size_t fields_before = memory->allocations(field);
    Float_field deformation = measurement.take_deformation();
    CHECK(deformation.memory() == memory && memory->allocations(field) == fields_before);

    // the levels: no field of the detector is elsewhere, and no more than were allowed are there at a time
    const auto try_with = [&](std::size_t levels_in_memory, std::size_t least, std::size_t most) {
      Amf::Extremum_options<> options;
      options.level_memory = levels_in_memory * level;
      const std::size_t before = memory->in_use(), levels_before = memory->allocations(level);
      Amf::Feature_detector<float> detector(sequence.rest_shape(), deformation, animation.frame_duration, options);
      CHECK(detector.field().memory() == memory && memory->in_use() == before + 1);
      memory->forget_most_in_use();
      CHECK(!detect_with(detector).empty());
      const std::size_t levels = memory->most_in_use() - before - 1;
      std::cout << levels_in_memory << " levels allowed: " << levels << " at a time, "
                << memory->allocations(level) - levels_before << " in all" << std::endl;
      CHECK(memory->allocations(level) - levels_before >= least);
      CHECK(levels >= least && levels <= most);
      CHECK(memory->in_use() == before + 1); // none is kept
    };
    try_with(0, 5, 5);
    try_with(8, 6, 8);
    try_with(1000, 9, 18);
    CHECK(memory->allocations(level) + memory->allocations(field) + 1 ==
          memory->allocations()); // the triangles' strain

    // a field elsewhere is searched elsewhere
    const std::size_t before = memory->allocations();
    Float_field on_the_heap(n, frames);
    for (std::size_t v = 0; v < n; ++v) std::copy(deformation.row(v), deformation.row(v) + frames, on_the_heap.row(v));
    Amf::Feature_detector<float> elsewhere(sequence.rest_shape(), on_the_heap, animation.frame_duration);
    CHECK(!detect_with(elsewhere).empty() && memory->allocations() == before);
  }
  CHECK(memory->in_use() == 0);

  // a copy of a field keeps its memory alive
  std::weak_ptr<Amf::Field_memory> own;
  {
    Field copy;
    {
      const auto short_lived = std::make_shared<Recording_memory>();
      own = short_lived;
      Field first(20, 10, short_lived);
      fill(first, 4);
      copy = first;
    }
    CHECK(!own.expired() && is_filled(copy, 4));
  }
  CHECK(own.expired());
}

int main()
{
  test_values(Amf::Field_memory::heap());
  test_values(std::make_shared<Recording_memory>());
  test_computed_fields();
  const std::vector<Feature> in_memory = detected(std::size_t(-1), Amf::Field_memory::heap());
  CHECK(in_memory.size() > 3);
  CHECK(same(in_memory, detected(0, Amf::Field_memory::heap())));
#ifdef __linux__
  std::shared_ptr<Amf::Field_memory> scratch;
  try {
    // with a limit that is always exceeded, everything is let go of all the time
    scratch = std::make_shared<Amf::Scratch_field_memory>(scratch_directory, 1);
  } catch (const Amf::Output_error& e) {
    std::cout << "SKIPPED: " << e.what() << std::endl;
    return test_result() == EXIT_SUCCESS ? 77 : EXIT_FAILURE;
  }
  test_values(scratch);
  CHECK(same(in_memory, detected(std::size_t(-1), scratch)));
  CHECK(same(in_memory, detected(0, scratch)));
  Field on_disk(1000, 100, scratch);
  scratch.reset();
  fill(on_disk, 5); // a field keeps its memory
  CHECK(is_filled(on_disk, 5));

  // What is in memory stays below the limit, at least as soon as the watching thread has had its turn.
  {
    constexpr std::size_t megabyte = std::size_t(1) << 20;
    const std::size_t before = Amf::internal::resident_memory(), limit = before + 64 * megabyte;
    Field large(400 * megabyte / 800, 100, std::make_shared<Amf::Scratch_field_memory>(scratch_directory, limit));
    fill(large, 1);
    for (int i = 0; i < 1000 && Amf::internal::resident_memory() > limit; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(Amf::internal::resident_memory() <= limit);
    CHECK(is_filled(large, 1));
  }

  // No file stays behind, and a directory that will not do says why.
  std::size_t left = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch_directory))
    left += entry.path().filename().string().find("animated_mesh_features_") != std::string::npos;
  CHECK(left == 0);
  CHECK_THROWS(Amf::Output_error, Amf::Scratch_field_memory("/no such directory", 1), "/no such directory");
  if (std::filesystem::exists("/dev/shm"))
    CHECK_THROWS(Amf::Output_error, Amf::Scratch_field_memory("/dev/shm", 1), "tmpfs");
  {
    Amf::Scratch_field_memory memory(scratch_directory, 1);
    CHECK_THROWS(Amf::Output_error, memory.allocate(std::size_t(1) << 60), "cannot make a file");
  }
#endif
  // An estimate grows with what it is of, and is never below the fields themselves.
  const Amf::Memory_estimate small = Amf::estimated_memory(10000, 50, 8), large = Amf::estimated_memory(20000, 50, 8);
  CHECK(small.fixed < large.fixed && small.least() < small.most() && small.most() < large.most());
  CHECK(small.level == Field::size_in_bytes(10000, 50) && small.fields == 4 * Field::size_in_bytes(10000, 50));
  CHECK(small.for_levels(small.most()) == small.most_levels * small.level);
  CHECK(small.for_levels(0) == small.least_levels * small.level);
  CHECK(Amf::estimated_memory(10000, 50, 8, 8).fixed > Amf::estimated_memory(10000, 50, 8, 2).fixed);
  // Weights of a long row are not F x F: ten times the frames take at most some ten times the memory.
  CHECK(Amf::estimated_memory(100, 100000, 8, 2).most() < 10.1 * Amf::estimated_memory(100, 10000, 8, 2).most());
  CHECK(Amf::available_memory() > 0);
  return test_result();
}
