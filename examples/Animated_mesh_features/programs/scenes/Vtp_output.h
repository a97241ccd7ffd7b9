// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_VTP_OUTPUT_H
#define PROGRAMS_SCENES_VTP_OUTPUT_H

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace Programs {

// "LittleEndian" or "BigEndian", which the machine is.
const char* vtk_byte_order();

// VTK's XML file of points, vertices and polygons at one time, with appended raw data: the values of all arrays, in the
// byte order of the machine, which the file tells, follow the XML. Arrays are kept by reference until `write()`.
class Vtp_output
{
public:
  Vtp_output(std::size_t points, std::size_t vertices, std::size_t triangles, double time);
  Vtp_output(const Vtp_output&) = delete;
  Vtp_output& operator=(const Vtp_output&) = delete;

  // Arrays come between the two.
  void begin(const std::string& section);
  void end(const std::string& section);
  // The section PointData: what shows the file shows the array `scalars` first, and lights it by `normals`; none if empty.
  void begin_point_data(const std::string& scalars, const std::string& normals = std::string());

  // `components` of each tuple; 0: an array of field data, which tells its number of tuples.
  template <class T>
  void array(const std::string& name, const std::vector<T>& values, std::size_t components = 1)
  {
    const std::string type = (std::is_floating_point<T>::value ? "Float" : "Int") + std::to_string(8 * sizeof(T));
    append_array(name, type, values.size(), components);
    append_block(values.data(), values.size() * sizeof(T));
  }

  // Once, at the end; errors are left in the state of the stream.
  void write(std::ostream& os);

private:
  void append_array(const std::string& name, const std::string& type, std::size_t size, std::size_t components);
  void append_block(const void* values, std::size_t bytes);

  std::vector<double> m_time;
  std::string m_xml;
  std::vector<std::pair<const char*, std::size_t>> m_blocks;
  std::uint64_t m_offset = 0;
};

} // namespace Programs

#endif // PROGRAMS_SCENES_VTP_OUTPUT_H
