// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_CSV_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_CSV_H

#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
#include <CGAL/Animated_mesh_features/IO/Vertex_origins.h>
#include <CGAL/Animated_mesh_features/IO/internal/Text_output.h>

#include <cstddef>
#include <ostream>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes features as a table of comma-separated values: a line of column names, then a line for each feature, in the order
of the range. Columns, units and digits are those of `write_json()`; points take three columns each, truth values are
`true` and `false`, and the `parent` of a feature without one is empty. With `origins` that are not empty, a last column
`file_vertices` has the vertices of the file of which the feature's vertex is made, with spaces between them. Independent of
the stream's locale.

\tparam FeatureRange a range of `Spatio_temporal_feature<VertexDescriptor>`

Errors are left in the state of the stream; `Output_file` reports them.
*/
template <class FeatureRange>
void write_csv(std::ostream& os, const FeatureRange& features, const Vertex_origins& origins = Vertex_origins())
{
  internal::Text_output out(os);
  out << "rank,vertex,frame,time,x,y,z,sigma,tau,radius,response,amplitude,fit,strength,place,parent,rest_x,rest_y,rest_z,"
         "triangle_0,triangle_1,triangle_2,barycentric_0,barycentric_1,barycentric_2,at_scale_limit";
  if (!origins.empty()) out << ",file_vertices";
  out << '\n';
  std::size_t rank = 0;
  for (const auto& f : features) {
    out << ++rank << ',' << f.vertex_index << ',' << f.frame << ',' << f.time;
    for (double x : f.position) out << ',' << x;
    out << ',' << f.sigma << ',' << f.tau << ',' << f.radius() << ',' << f.response << ',' << f.amplitude
        << ',' << f.fit << ',' << f.strength << ',' << f.place + 1 << ',';
    if (f.parent != Feature_point::none) out << f.parent + 1;
    for (double x : f.rest_position) out << ',' << x;
    for (std::size_t v : f.triangle) out << ',' << v;
    for (double b : f.barycentric_coordinates) out << ',' << b;
    out << ',' << f.at_scale_limit;
    if (!origins.empty()) {
      const char* separator = ",";
      for (std::size_t v : origins.of(f.vertex_index)) {
        out << separator << v;
        separator = " ";
      }
    }
    out << '\n';
  }
  out.flush();
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_CSV_H
