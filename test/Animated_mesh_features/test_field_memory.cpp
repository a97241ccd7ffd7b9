// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Fields in scratch files: the same values as in memory, whatever is let go of; a detection on them has the same bits;
// errors of directories.

#include "test_shapes.h"
#include "test_support.h"

#include <CGAL/Animated_mesh_features/Detection/Memory_estimate.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/Scratch_field_memory.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "generators/bending_cylinder.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
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
void test_values()
{
  for (const std::size_t frames : {1, 7, 8, 60, 511, 512}) {
    Field field(37, frames);
    CHECK(is_zero(field));
    CHECK(reinterpret_cast<std::uintptr_t>(field.row(0)) % 64 == 0);
    CHECK(reinterpret_cast<std::uintptr_t>(field.row(1)) % 64 == 0);
    CHECK(field.size_in_bytes() == Field::size_in_bytes(37, frames));
    fill(field, 3);
    Field copy = field, other(5, frames), same_size(37, frames);
    fill(field, 2);
    CHECK(is_filled(copy, 3));
    other = copy;
    same_size = copy;
    CHECK(is_filled(other, 3) && other.number_of_rows() == 37 && is_filled(same_size, 3));
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
  CHECK(copy.number_of_rows() == 0 && copy.size_in_bytes() == 0);
}

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Amf::Spatio_temporal_feature<Mesh::Vertex_index> Feature;

std::vector<Feature> detected(std::size_t level_memory)
{
  Animated_mesh_generators::Bending_cylinder_options options;
  options.vertices_around = 14;
  options.number_of_frames = 30;
  options.frame_rate = 15;
  const auto animation = Animated_mesh_generators::bending_cylinder(options);
  const Amf::Frame_sequence<Mesh> sequence(animation.mesh, animation.frames, animation.frame_duration);
  Amf::Feature_detector<Amf::Frame_sequence<Mesh>> detector(sequence);
  detector.set_level_memory(level_memory);
  detector.selection().relative_threshold = 0;
  std::vector<Feature> features;
  detector(std::back_inserter(features));
  return features;
}

bool same(const std::vector<Feature>& a, const std::vector<Feature>& b)
{
  bool equal = a.size() == b.size();
  for (std::size_t i = 0; equal && i < a.size(); ++i)
    equal = a[i].vertex == b[i].vertex && a[i].time == b[i].time && a[i].sigma == b[i].sigma && a[i].tau == b[i].tau &&
            a[i].response == b[i].response && a[i].position == b[i].position;
  return equal;
}

int main()
{
  test_values();
  const std::vector<Feature> in_memory = detected(std::size_t(-1));
  CHECK(in_memory.size() > 3);
  CHECK(same(in_memory, detected(0)));
#ifdef __linux__
  std::shared_ptr<Amf::Field_memory> scratch;
  try {
    // with a limit that is always exceeded, everything is let go of all the time
    scratch = std::make_shared<Amf::Scratch_field_memory>(scratch_directory, 1);
  } catch (const Amf::Output_error& e) {
    std::cout << "SKIPPED: " << e.what() << std::endl;
    return test_result() == EXIT_SUCCESS ? 77 : EXIT_FAILURE;
  }
  Field on_disk;
  {
    const Amf::Field_memory_scope scope(scratch);
    CHECK(Amf::Field_memory::current() == scratch);
    test_values();
    CHECK(same(in_memory, detected(std::size_t(-1))));
    CHECK(same(in_memory, detected(0)));
    on_disk = Field(1000, 100);
  }
  CHECK(Amf::Field_memory::current() != scratch);
  scratch.reset();
  fill(on_disk, 5); // a field keeps its memory
  CHECK(is_filled(on_disk, 5));

  // What is in memory stays below the limit, at least as soon as the watching thread has had its turn.
  {
    constexpr std::size_t megabyte = std::size_t(1) << 20;
    const std::size_t before = Amf::internal::resident_memory(), limit = before + 64 * megabyte;
    const Amf::Field_memory_scope scope(std::make_shared<Amf::Scratch_field_memory>(scratch_directory, limit));
    Field large(400 * megabyte / 800, 100);
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
  CHECK(Amf::available_memory() > 0);
  return test_result();
}
