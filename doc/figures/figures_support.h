// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_FEATURES_FIGURES_SUPPORT_H
#define ANIMATED_MESH_FEATURES_FIGURES_SUPPORT_H

// What the programs that compute the manual's figures share: the numbers of a figure as JSON, and a loop for filters that
// are used without a detector.

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace figures {

typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::Animated_mesh_features::Frame_sequence<Mesh> Frame_sequence;

/// What a `SpatialFilter` and a `GeodesicBalls` call with their tasks: one after the other.
struct Plain_loop
{
  template <class Task>
  void operator()(std::size_t n, const Task& task) const
  {
    for (std::size_t i = 0; i < n; ++i) task(i);
  }
  Plain_loop part(std::size_t, std::size_t) const { return *this; }
};

/// a body that does not move.
inline Frame_sequence at_rest(const Mesh& mesh, std::size_t frames, double frame_duration)
{
  const std::vector<Point_3> points(mesh.points().begin(), mesh.points().end());
  return Frame_sequence(mesh, std::vector<std::vector<Point_3>>(frames, points), frame_duration);
}

/// Numbers and lists of numbers by name, in a file of their own. Six digits: more than a figure shows, and fewer than
/// compilers agree on.
class Json_file
{
public:
  explicit Json_file(const std::string& path)
    : m_out(path)
    , m_path(path)
  {
    m_out << "{";
  }

  ~Json_file() { m_out << "\n}\n"; }

  void add(const std::string& name, double x)
  {
    begin(name);
    write(x);
  }

  void add(const std::string& name, const std::vector<double>& list)
  {
    begin(name);
    write(list);
    if (!m_out) throw std::runtime_error("cannot write " + m_path);
  }

  void add(const std::string& name, const std::vector<std::vector<double>>& rows)
  {
    begin(name);
    m_out << '[';
    for (std::size_t i = 0; i < rows.size(); ++i) {
      m_out << (i > 0 ? ",\n  " : "");
      write(rows[i]);
    }
    m_out << ']';
    if (!m_out) throw std::runtime_error("cannot write " + m_path);
  }

private:
  void begin(const std::string& name)
  {
    m_out << (m_is_first ? "\n" : ",\n") << " \"" << name << "\": ";
    m_is_first = false;
  }
  void write(double x)
  {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", x);
    m_out << text;
  }
  void write(const std::vector<double>& list)
  {
    m_out << '[';
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (i > 0) m_out << ", ";
      write(list[i]);
    }
    m_out << ']';
  }

  std::ofstream m_out;
  std::string m_path;
  bool m_is_first = true;
};

} // namespace figures

#endif // ANIMATED_MESH_FEATURES_FIGURES_SUPPORT_H
