// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// An animated mesh with fewer triangles: CGAL's edge collapse with the policies of this package, and a stop predicate
// of CGAL's own. What is left follows the original in every frame.

#include "generators/bending_cylinder.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Applications/Animation_collapse.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1050600000
  #include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_count_ratio_stop_predicate.h>
#else
  #include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#endif

#include <iostream>

namespace AMF = CGAL::Animated_mesh_features;
namespace SMS = CGAL::Surface_mesh_simplification;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
#if CGAL_VERSION_NR >= 1050600000
typedef SMS::Edge_count_ratio_stop_predicate<Mesh> Stop;
#else
typedef SMS::Count_ratio_stop_predicate<Mesh> Stop;
#endif

int main()
{
  Animated_mesh_generators::Bending_cylinder_options cylinder_options;
  cylinder_options.vertices_around = 18;
  const auto cylinder = Animated_mesh_generators::bending_cylinder(cylinder_options);
  const AMF::Frame_sequence<Mesh> animation(cylinder.mesh, cylinder.frames, cylinder.frame_duration);

  //! [collapse]
  Mesh mesh = cylinder.mesh; // whose vertices are numbered from 0
  const auto index = get(boost::vertex_index, mesh);
  AMF::Animation_collapse<Mesh, decltype(get(boost::vertex_index, mesh))> collapse(
      mesh, index, animation.rest_shape(), animation.trajectories(), AMF::Simplification_options());
  const auto cost = collapse.cost();
  const auto placement = collapse.placement();
  const auto filter = collapse.filter();
  SMS::edge_collapse(mesh, Stop(.1),
                     CGAL::parameters::get_cost(cost).get_placement(placement).filter(filter).visitor(
                         collapse.visitor(SMS::Edge_collapse_visitor_base<Mesh>())));

  AMF::Vertex_binding binding;
  for (auto v : vertices(mesh)) collapse.bind(v, binding);
  //! [collapse]
  std::cout << cylinder.mesh.number_of_vertices() << " vertices became " << binding.size() << std::endl;
  const auto positions = binding.positions(animation.trajectories().frame(20));
  std::cout << "the first is at " << positions[0].transpose() << " in frame 20" << std::endl;
  return binding.size() < cylinder.mesh.number_of_vertices() / 5 ? 0 : 1;
}
