// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_SURFACE_PLAN_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_SURFACE_PLAN_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Edge_measures.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Surface_components.h>
#include <CGAL/Animated_mesh_features/Animation/internal/rows_of_vertices.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The parts from which a component is assembled, all without any rotation: each triangle laid out in its own plane, and
// for each pair of neighbours how the second one is turned as seen from the first. Indices are those of the component.
//
// A frame R of a triangle takes its plane into space: columns 0 and 1 span it, column 2 is the normal. At an edge with
// angle theta, whose directions in the two planes are a_l and a_r,
//   R_right = R_left Rz(a_l) Rx(theta) Rz(-a_r),
// since both Rz(a) bring the first axis to the edge; the transition matrices of Y. Wang, B. Liu, Y. Tong, Linear
// surface reconstruction from discrete fundamental forms on triangle meshes, Computer Graphics Forum 31(8), 2012; for
// frames at vertices Y. Lipman et al., Linear rotation-invariant coordinates for meshes, ACM Trans. Graph. 24(3), 2005.
struct Surface_plan
{
  typedef Compressed_rows::Index Index;

  struct Triangle
  {
    std::array<Index, 3> vertices;
    unsigned base;                        // the corner at which the longest edge starts; that edge is the first axis
    std::array<Eigen::Vector2d, 3> edges; // from corner k to corner k + 1
    double weight;                        // of its edges when positions are fitted
    std::array<Index, 3> joints;          // across edge k, or no_joint
  };
  struct Joint
  {
    Index left, right;
    double weight; // length^2, as the squared edges have
    Eigen::Matrix3d transition;
  };
  static constexpr Index no_joint = Rest_shape::none;

  // Slivers count less, as their normals are easily upset, but they do count, as a vertex may have no other triangles.
  static constexpr double least_weight = 1e-3;

  std::size_t number_of_vertices;
  std::vector<Triangle> triangles;        // by colour: no two of a colour are neighbours
  std::vector<std::size_t> colours;       // where each colour starts in `triangles`, and the end
  std::vector<Rest_shape::Index> original; // of each triangle, the one of the shape
  std::vector<Joint> joints;
  Compressed_rows corners;                // of the triangles, around each vertex: 3 * triangle + corner
  double squared_length = 0;              // the sum over all triangles and their edges

  // `rank_of_vertex` and `rank_of_triangle` are scratch, with an element for each of the shape, of which those of the
  // component are used.
  Surface_plan(const Rest_shape& shape, const Triangle_adjacency& adjacency, const Surface_component& component,
               const Edge_measures& measures, std::vector<Index>& rank_of_vertex, std::vector<Index>& rank_of_triangle)
    : number_of_vertices(component.vertices.size())
  {
    sort_by_colour(adjacency, component, rank_of_triangle);
    for (std::size_t i = 0; i < component.vertices.size(); ++i) rank_of_vertex[component.vertices[i]] = Index(i);
    triangles.reserve(original.size());
    std::vector<double> areas;
    areas.reserve(original.size());
    for (Rest_shape::Index t : original) {
      Triangle triangle;
      std::array<double, 3> lengths;
      for (unsigned k = 0; k < 3; ++k) {
        triangle.vertices[k] = rank_of_vertex[shape.triangles()[t][k]];
        lengths[k] = measures.lengths[adjacency.edges[t][k]];
        triangle.joints[k] = no_joint;
      }
      areas.push_back(lay_out(lengths, triangle));
      for (double l : lengths) squared_length += l * l;
      triangles.push_back(triangle);
    }
    corners = rows_of_vertices(
        number_of_vertices, 3 * triangles.size(), [](std::size_t i) { return Index(i); },
        [this](Index i) { return std::array<Index, 1>{{triangles[i / 3].vertices[i % 3]}}; });
    for (std::size_t i = 0; i < original.size(); ++i) rank_of_triangle[original[i]] = Index(i);
    for (Rest_shape::Index e : component.edges)
      if (adjacency.is_interior(e)) join(adjacency.sides[e], measures.lengths[e], measures.angles[e], areas, rank_of_triangle);
  }

private:
  // Each triangle takes the first colour that none of its neighbours has, hence one of four.
  void sort_by_colour(const Triangle_adjacency& adjacency, const Surface_component& component,
                      std::vector<Index>& rank)
  {
    constexpr Index most_colours = 4;
    std::array<std::vector<Rest_shape::Index>, most_colours> by_colour;
    for (Rest_shape::Index t : component.triangles) rank[t] = most_colours;
    for (Rest_shape::Index t : component.triangles) {
      std::array<bool, most_colours + 1> is_taken = {};
      for (unsigned k = 0; k < 3; ++k) {
        const Rest_shape::Index g = adjacency.neighbour(t, k);
        if (g != Rest_shape::none && g != t) is_taken[rank[g]] = true;
      }
      rank[t] = Index(std::find(is_taken.begin(), is_taken.end(), false) - is_taken.begin());
      by_colour[rank[t]].push_back(t);
    }
    colours.push_back(0);
    original.reserve(component.triangles.size());
    for (const std::vector<Rest_shape::Index>& some : by_colour) {
      original.insert(original.end(), some.begin(), some.end());
      if (original.size() > colours.back()) colours.push_back(original.size());
    }
  }

  // Places the triangle by its lengths, longest edge on the first axis. Returns its area.
  static double lay_out(const std::array<double, 3>& lengths, Triangle& triangle)
  {
    const unsigned b = triangle.base = unsigned(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
    const double base = lengths[b], next = lengths[(b + 1) % 3], last = lengths[(b + 2) % 3];
    // law of cosines; the foot is between the corners, as the base is longest
    const double foot = base > 0 ? (base + (last - next) * ((last + next) / base)) / 2 : 0;
    const double height = std::sqrt((std::max)(0., (last - foot) * (last + foot)));
    triangle.edges[b] = Eigen::Vector2d(base, 0);
    triangle.edges[(b + 1) % 3] = Eigen::Vector2d(foot - base, height);
    triangle.edges[(b + 2) % 3] = Eigen::Vector2d(-foot, -height);
    const double area = base * height / 2;
    // 1 for the equilateral triangle
    const double quality = 4 * std::sqrt(3.) * area / (base * base + next * next + last * last);
    triangle.weight = base > 0 ? (std::max)(least_weight, quality) : least_weight;
    return area;
  }

  void join(const std::array<Triangle_adjacency::Side, 2>& sides, double length, const Eigen::Vector2d& angle,
            const std::vector<double>& areas, const std::vector<Index>& rank)
  {
    if (sides[0].triangle == sides[1].triangle) return; // folded onto itself
    Joint joint;
    joint.left = rank[sides[0].triangle];
    joint.right = rank[sides[1].triangle];
    const double a = areas[joint.left], b = areas[joint.right];
    joint.weight = (a + b > 0 ? 2 * a * b / (a + b) : 0.) + least_weight * length * length;
    const Eigen::Vector2d l = triangles[joint.left].edges[sides[0].corner].normalized();
    const Eigen::Vector2d r = -triangles[joint.right].edges[sides[1].corner].normalized();
    if (l.isZero() || r.isZero()) return; // a point, about which anything may turn
    Eigen::Matrix3d turn;
    turn << 1, 0, 0, 0, angle.x(), -angle.y(), 0, angle.y(), angle.x();
    joint.transition = about_normal(l) * turn * about_normal(r).transpose();
    triangles[joint.left].joints[sides[0].corner] = Index(joints.size());
    triangles[joint.right].joints[sides[1].corner] = Index(joints.size());
    joints.push_back(joint);
  }

  static Eigen::Matrix3d about_normal(const Eigen::Vector2d& d)
  {
    Eigen::Matrix3d r;
    r << d.x(), -d.y(), 0, d.y(), d.x(), 0, 0, 0, 1;
    return r;
  }
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_SURFACE_PLAN_H
