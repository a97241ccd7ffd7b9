// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/Vtp_output.h"

#include "scenes/append_xml_text.h"

#include <boost/endian/conversion.hpp>

namespace Programs {

const char* vtk_byte_order()
{
  return boost::endian::order::native == boost::endian::order::little ? "LittleEndian" : "BigEndian";
}

Vtp_output::Vtp_output(std::size_t points, std::size_t vertices, std::size_t triangles, double time)
  : m_time({time})
{
  m_xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"";
  m_xml += vtk_byte_order();
  m_xml += "\" header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n";
  array("TimeValue", m_time, 0); // by which ParaView knows the time of a file on its own
  m_xml += "</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfVerts=\"" +
           std::to_string(vertices) + "\" NumberOfPolys=\"" + std::to_string(triangles) + "\">\n";
}

void Vtp_output::begin(const std::string& section)
{
  m_xml += "<" + section + ">\n";
}

void Vtp_output::begin_point_data(const std::string& scalars, const std::string& normals)
{
  m_xml += "<PointData";
  const auto append = [&](const char* what, const std::string& name) {
    if (name.empty()) return;
    m_xml += std::string(" ") + what + "=\"";
    append_xml_text(m_xml, name);
    m_xml += '"';
  };
  append("Scalars", scalars);
  append("Normals", normals);
  m_xml += ">\n";
}

void Vtp_output::end(const std::string& section)
{
  m_xml += "</" + section + ">\n";
}

void Vtp_output::append_array(const std::string& name, const std::string& type, std::size_t size,
                              std::size_t components)
{
  m_xml += "<DataArray type=\"" + type + "\" Name=\"";
  append_xml_text(m_xml, name);
  m_xml += components == 0 ? "\" NumberOfTuples=\"" + std::to_string(size)
                           : "\" NumberOfComponents=\"" + std::to_string(components);
  m_xml += "\" format=\"appended\" offset=\"" + std::to_string(m_offset) + "\"/>\n";
}

void Vtp_output::append_block(const void* values, std::size_t bytes)
{
  m_blocks.emplace_back(static_cast<const char*>(values), bytes);
  m_offset += sizeof(std::uint64_t) + bytes;
}

void Vtp_output::write(std::ostream& os)
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

} // namespace Programs
