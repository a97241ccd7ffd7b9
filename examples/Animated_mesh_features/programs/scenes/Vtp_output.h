// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_VTP_OUTPUT_H
#define PROGRAMS_SCENES_VTP_OUTPUT_H

#include "scenes/append_xml_text.h"
#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

inline const char* vtk_byte_order()
{
  return native_byte_order() == Byte_order::LITTLE_ENDIAN_ORDER ? "LittleEndian" : "BigEndian";
}

// VTK's XML file of points, vertices and polygons at one time, with appended raw data: the values of all arrays, in the
// byte order of the machine, which the file tells, follow the XML. Arrays are kept by reference until `write()`.
class Vtp_output
{
public:
  Vtp_output(std::size_t points, std::size_t vertices, std::size_t triangles, double time)
    : m_time({time})
  {
    m_xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"";
    m_xml += vtk_byte_order();
    m_xml += "\" header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n";
    array("TimeValue", m_time, 0); // by which ParaView knows the time of a file on its own
    m_xml += "</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfVerts=\"" +
             std::to_string(vertices) + "\" NumberOfPolys=\"" + std::to_string(triangles) + "\">\n";
  }
  Vtp_output(const Vtp_output&) = delete;
  Vtp_output& operator=(const Vtp_output&) = delete;

  // Arrays come between the two. What shows the file shows the array `scalars` first.
  void begin(std::string_view section) { (m_xml += '<').append(section) += ">\n"; }
  void begin(std::string_view section, std::string_view scalars)
  {
    (m_xml += '<').append(section) += " Scalars=\"";
    append_xml_text(m_xml, scalars);
    m_xml += "\">\n";
  }
  void end(std::string_view section) { (m_xml += "</").append(section) += ">\n"; }

  // `components` of each tuple; 0: an array of field data, which tells its number of tuples.
  template <class T>
  void array(std::string_view name, const std::vector<T>& values, std::size_t components = 1)
  {
    m_xml += "<DataArray type=\"";
    m_xml += std::is_floating_point<T>::value ? "Float" : "Int";
    m_xml += std::to_string(8 * sizeof(T)) + "\" Name=\"";
    append_xml_text(m_xml, name);
    m_xml += components == 0 ? "\" NumberOfTuples=\"" + std::to_string(values.size())
                             : "\" NumberOfComponents=\"" + std::to_string(components);
    m_xml += "\" format=\"appended\" offset=\"" + std::to_string(m_offset) + "\"/>\n";
    const std::size_t bytes = values.size() * sizeof(T);
    m_blocks.emplace_back(reinterpret_cast<const char*>(values.data()), bytes);
    m_offset += sizeof(std::uint64_t) + bytes;
  }

  // Once, at the end; errors are left in the state of the stream.
  void write(std::ostream& os)
  {
    m_xml += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
    os.write(m_xml.data(), static_cast<std::streamsize>(m_xml.size()));
    for (const auto& block : m_blocks) {
      const std::uint64_t size = block.second;
      os.write(reinterpret_cast<const char*>(&size), sizeof(size));
      if (size > 0) os.write(block.first, static_cast<std::streamsize>(size));
    }
    os << "\n</AppendedData>\n</VTKFile>\n";
  }

private:
  std::vector<double> m_time;
  std::string m_xml;
  std::vector<std::pair<const char*, std::size_t>> m_blocks;
  std::uint64_t m_offset = 0;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_SCENES_VTP_OUTPUT_H
