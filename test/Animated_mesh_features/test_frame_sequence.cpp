// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What Frame_sequence takes and what it refuses, with messages by which the fault can be found; and that what is unusual but
// allowed - several components, borders, isolated vertices, degenerate triangles - is counted, and does no harm.

#include "test_bumpy_sphere.h"
#include "test_support.h"
#include "test_two_stages.h"

#include <CGAL/Animated_mesh_features/Animation/Canonical_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Frame_positions.h>
#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Animation/rest_shape_of_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace test_support;
namespace AMF = CGAL::Animated_mesh_features;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef std::vector<std::vector<Point_3>> Frames;
typedef AMF::Frame_sequence<Mesh> Sequence;

const double infinity = std::numeric_limits<double>::infinity();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

std::vector<Point_3> scaled(std::vector<Point_3> points, double factor)
{
  for (Point_3& p : points) p = Point_3(factor * p.x(), factor * p.y(), factor * p.z());
  return points;
}

AMF::Spatio_temporal_field<double> coordinate(const Frames& frames, int i)
{
  AMF::Spatio_temporal_field<double> field(frames[0].size(), frames.size());
  for (std::size_t f = 0; f < frames.size(); ++f)
    for (std::size_t v = 0; v < frames[f].size(); ++v) field(v, f) = frames[f][v][i];
  return field;
}

void test_positions(const Bumpy_sphere& sphere, const Mesh& mesh)
{
  Sequence sequence(mesh, sphere.frames, sphere.frame_duration);
  const Sequence from_fields(mesh, coordinate(sphere.frames, 0), coordinate(sphere.frames, 1),
                             coordinate(sphere.frames, 2), sphere.frame_duration);
  CHECK(sequence.number_of_frames() == sphere.frames.size());
  CHECK(sequence.number_of_vertices() == sphere.rest.size());
  CHECK(sequence.frame_duration() == sphere.frame_duration);
  CHECK(&sequence.triangle_mesh() == &mesh);
  bool same = true, rest_is_first = true, rank = true;
  std::size_t i = 0;
  for (Mesh::Vertex_index v : vertices(mesh)) {
    rank = rank && get(sequence.vertex_index_map(), v) == i;
    for (std::size_t f : {std::size_t(0), std::size_t(11), sphere.frames.size() - 1})
      same = same && get(sequence.point_map(f), v) == sphere.frames[f][i] &&
             get(from_fields.point_map(f), v) == sphere.frames[f][i];
    rest_is_first = rest_is_first && get(sequence.rest_point_map(), v) == sphere.frames[0][i];
    ++i;
  }
  CHECK(same);
  CHECK(rest_is_first);
  CHECK(rank);

  sequence.set_rest_frame(13);
  CHECK(get(sequence.rest_point_map(), *vertices(mesh).begin()) == sphere.frames[13][0]);
  CHECK(sequence.set_rest_shape(sphere.rest) == 1);
  CHECK(get(sequence.rest_point_map(), *vertices(mesh).begin()) == sphere.rest[0]);
  CHECK_THROWS(AMF::Input_error, sequence.set_rest_frame(24), "no frame 24");
  CHECK_THROWS(AMF::Input_error, sequence.set_rest_frame(24), "0 to 23");
  // an error leaves the rest shape alone
  CHECK(get(sequence.rest_point_map(), *vertices(mesh).begin()) == sphere.rest[0]);
}

// A frame as a view, and the rest shape of a mesh that has no frames.
void test_views(const Bumpy_sphere& sphere, const Mesh& mesh)
{
  typedef AMF::Rest_shape::Point Point;
  const AMF::Frame_sequence<Mesh, float> sequence(mesh, sphere.frames, sphere.frame_duration);
  const AMF::Vertex_trajectories<float>& trajectories = sequence.trajectories();
  CHECK(trajectories.number_of_vertices() == 642 && trajectories.number_of_frames() == 24);
  bool same = true;
  for (std::size_t f : {0, 11, 23}) {
    const AMF::Frame_positions<float> positions = trajectories.frame(f);
    const std::vector<Point> points = positions.points();
    same = same && positions.size() == 642 && points.size() == 642;
    for (std::size_t v = 0; v < points.size(); ++v) {
      const Point_3& p = sphere.frames[f][v]; // whose coordinates are floats
      const Point expected(p.x(), p.y(), p.z());
      same = same && positions[v] == expected && points[v] == expected && trajectories.point(v, f) == expected;
    }
  }
  CHECK(same);
  // of fields on their own, and of what is in them now
  AMF::Spatio_temporal_field<double> x(2, 3), y(2, 3), z(2, 3);
  const AMF::Frame_positions<double> view(x, y, z, 2);
  x(1, 2) = 4, y(1, 2) = 5, z(1, 2) = 6, x(1, 1) = 7;
  CHECK(view.size() == 2 && view[0] == Point::Zero() && view[1] == Point(4, 5, 6));

  const AMF::Rest_shape shape = AMF::rest_shape_of_mesh(mesh);
  CHECK(shape.number_of_vertices() == 642 && shape.triangles().size() == 1280 && shape.edges().size() == 1920);
  const AMF::Rest_shape moved = AMF::rest_shape_of_mesh(mesh, sequence.point_map(11));
  CHECK(shape.triangles() == moved.triangles());
  same = true;
  for (std::size_t v = 0; v < 642; ++v)
    same = same && shape.points()[v] == Point(sphere.rest[v].x(), sphere.rest[v].y(), sphere.rest[v].z()) &&
           moved.points()[v] == trajectories.point(v, 11);
  CHECK(same);
  Mesh bad = mesh;
  bad.point(Mesh::Vertex_index(3)) = Point_3(0, not_a_number, 0);
  CHECK_THROWS(AMF::Input_error, AMF::rest_shape_of_mesh(bad), "the mesh: the position of vertex 3 is not finite");
  CHECK_THROWS(AMF::Input_error, AMF::rest_shape_of_mesh(Mesh()), "the mesh has no faces");
}

void test_bad_connectivity(const Bumpy_sphere& sphere)
{
  Mesh mesh;
  const auto a = mesh.add_vertex(Point_3(0, 0, 0)), b = mesh.add_vertex(Point_3(1, 0, 0)),
             c = mesh.add_vertex(Point_3(1, 1, 0)), d = mesh.add_vertex(Point_3(0, 1, 0)),
             e = mesh.add_vertex(Point_3(2, 0, 0));
  const Frames frames(3,
                      std::vector<Point_3>{mesh.point(a), mesh.point(b), mesh.point(c), mesh.point(d), mesh.point(e)});
  CHECK_THROWS(AMF::Input_error, Sequence(mesh, frames, 1), "the mesh has no faces");
  mesh.add_face(b, e, c);
  mesh.add_face(a, b, c, d);
  CHECK_THROWS(AMF::Input_error, Sequence(mesh, frames, 1), "face 1 has 4 vertices");
  CHECK_THROWS(AMF::Input_error, AMF::rest_shape_of_mesh(mesh), "face 1 has 4 vertices");
  CHECK_THROWS(AMF::Input_error, Sequence(Mesh(), sphere.frames, 1), "the mesh has no faces");
}

void test_bad_frames(const Bumpy_sphere& sphere, const Mesh& mesh)
{
  const double dt = sphere.frame_duration;
  Frames frames = sphere.frames;
  frames[5].pop_back();
  CHECK_THROWS(AMF::Input_error, Sequence(mesh, frames, dt), "frame 5 has 641 points, the mesh has 642 vertices");
  for (double bad : {infinity, -infinity, not_a_number})
    for (int i = 0; i < 3; ++i) {
      double p[3] = {1, 2, 3};
      p[i] = bad;
      frames = sphere.frames;
      frames[7][123] = Point_3(p[0], p[1], p[2]);
      const std::string message = "frame 7: the position of vertex 123 is not finite";
      CHECK_THROWS(AMF::Input_error, Sequence(mesh, frames, dt), message);
      CHECK_THROWS(AMF::Input_error,
                   Sequence(mesh, coordinate(frames, 0), coordinate(frames, 1), coordinate(frames, 2), dt), message);
    }
  frames = sphere.frames;
  frames[7][123] = Point_3(1e300, 0, 0); // too large a number for float
  CHECK(Sequence(mesh, frames, dt).number_of_frames() == 24);
  CHECK_THROWS(AMF::Input_error, (AMF::Frame_sequence<Mesh, float>(mesh, frames, dt)), "vertex 123 is not finite");

  const Frames two(sphere.frames.begin(), sphere.frames.begin() + 2);
  CHECK_THROWS(AMF::Input_error, Sequence(mesh, two, dt), "2 frame(s); at least 3");
  CHECK_THROWS(AMF::Input_error, Sequence(mesh, Frames(), dt), "0 frame(s); at least 3");
  for (double bad : {0., -1., infinity, not_a_number})
    CHECK_THROWS(AMF::Input_error, Sequence(mesh, sphere.frames, bad), "must be positive");

  const AMF::Spatio_temporal_field<double> x = coordinate(sphere.frames, 0), shorter(642, 23), smaller(641, 24);
  CHECK_THROWS(AMF::Input_error, Sequence(mesh, x, shorter, x, dt), "642 x 23");
  CHECK_THROWS(AMF::Input_error, Sequence(mesh, x, x, smaller, dt), "641 x 24, the mesh has 642 vertices");
}

void test_rest_shape(const Bumpy_sphere& sphere, const Mesh& mesh)
{
  const Frames still(3, sphere.rest);
  Sequence sequence(mesh, still, 1);
  const double edge = sequence.rest_shape().mean_edge_length();

  std::vector<Point_3> bad = sphere.rest;
  bad.pop_back();
  CHECK_THROWS(AMF::Input_error, sequence.set_rest_shape(bad), "the rest shape");
  CHECK_THROWS(AMF::Input_error, sequence.set_rest_shape(bad), "641 points");
  bad = sphere.rest;
  bad[3] = Point_3(0, not_a_number, 0);
  CHECK_THROWS(AMF::Input_error, sequence.set_rest_shape(bad), "vertex 3 is not finite");
  CHECK_THROWS(AMF::Input_error, sequence.set_rest_shape(scaled(sphere.rest, 0)), "length zero");

  // half and four times the size: the ratio and what can be done about it are in the message
  CHECK_THROWS(AMF::Input_error, sequence.set_rest_shape(scaled(sphere.rest, 0.5)), "is 2 times as long");
  CHECK_THROWS(AMF::Input_error, sequence.set_rest_shape(scaled(sphere.rest, 4)), "is 0.25 times as long");
  CHECK_THROWS(AMF::Input_error, sequence.set_rest_shape(scaled(sphere.rest, 4)), "Rest_unit::RESCALE");
  CHECK_THROWS(AMF::Input_error, sequence.set_rest_shape(scaled(sphere.rest, 4)), "--rescale-rest");
  CHECK(sequence.rest_shape().mean_edge_length() == edge);

  CHECK(sequence.set_rest_shape(scaled(sphere.rest, 0.5), AMF::Rest_unit::RESCALE) == 2);
  CHECK(sequence.rest_shape().mean_edge_length() == edge);
  CHECK(sequence.set_rest_shape(scaled(sphere.rest, 4), AMF::Rest_unit::KEEP) == 1);
  CHECK(sequence.rest_shape().mean_edge_length() == 4 * edge);
  // growth by a quarter passes for deformation, by a half it does not
  CHECK(sequence.set_rest_shape(scaled(sphere.rest, 1.25)) == 1);
  CHECK_NEAR(sequence.rest_shape().mean_edge_length(), 1.25 * edge, 1e-14);
  CHECK_THROWS(AMF::Input_error, sequence.set_rest_shape(scaled(sphere.rest, 1.5)), "another unit");

  // where nothing moves, the canonical shape is what is there
  AMF::set_canonical_rest_shape(sequence);
  double largest = 0;
  for (std::size_t v = 0; v < sphere.rest.size(); ++v)
    largest = (std::max)(largest, CGAL::squared_distance(
                                      get(sequence.rest_point_map(), Mesh::Vertex_index(unsigned(v))), sphere.rest[v]));
  CHECK_NEAR(std::sqrt(largest), 0, 1e-9);
}

// The sphere, a square sheet with a sliver of height zero between its triangles, two isolated vertices, a triangle whose
// corners lie on a line, and one whose corners are one point.
struct Unusual_animation
{
  Mesh mesh;
  Frames frames;
  double frame_duration;
  std::size_t first_after_sphere;

  explicit Unusual_animation(const Bumpy_sphere& sphere)
    : frame_duration(sphere.frame_duration)
  {
    add_sphere(sphere, mesh);
    first_after_sphere = mesh.number_of_vertices();
    add_sheet();
    mesh.add_vertex(Point_3(0, 3, 0));
    mesh.add_vertex(Point_3(0, 4, 0));
    add_triangle(Point_3(0, 5, 0), Point_3(0, 5.25, 0), Point_3(0, 5.75, 0));
    add_triangle(Point_3(0, 6, 0), Point_3(0, 6, 0), Point_3(0, 6, 0));
    for (std::size_t f = 0; f < sphere.frames.size(); ++f) {
      std::vector<Point_3> points = sphere.frames[f];
      for (std::size_t v = first_after_sphere; v < mesh.number_of_vertices(); ++v) {
        const Point_3& p = mesh.point(Mesh::Vertex_index(unsigned(v)));
        const double wave = 0.2 * std::sin(p.x() + 2 * p.y()) * std::exp(-std::pow(double(f) - 9.5, 2) / 6);
        points.emplace_back(p.x(), p.y(), p.z() + wave);
      }
      frames.push_back(points);
    }
  }

private:
  static constexpr int side = 12; // vertices

  void add_triangle(const Point_3& p, const Point_3& q, const Point_3& r)
  {
    const auto a = mesh.add_vertex(p), b = mesh.add_vertex(q), c = mesh.add_vertex(r);
    mesh.add_face(a, b, c);
  }

  void add_sheet()
  {
    std::vector<Mesh::Vertex_index> v;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) v.push_back(mesh.add_vertex(Point_3(4 + i / 8., j / 8., 0)));
    for (int j = 0; j + 1 < side; ++j)
      for (int i = 0; i + 1 < side; ++i) {
        const auto a = v[j * side + i], b = v[j * side + i + 1], c = v[(j + 1) * side + i + 1],
                   d = v[(j + 1) * side + i];
        if (i == 5 && j == 5) {
          const auto m = mesh.add_vertex(CGAL::midpoint(mesh.point(a), mesh.point(c)));
          mesh.add_face(a, b, m);
          mesh.add_face(b, c, m);
          mesh.add_face(a, m, c);
        } else {
          mesh.add_face(a, b, c);
        }
        mesh.add_face(a, c, d);
      }
  }
};

void test_unusual(const Bumpy_sphere& sphere)
{
  const Unusual_animation animation(sphere);
  Sequence sequence(animation.mesh, animation.frames, animation.frame_duration);
  CHECK(sequence.set_rest_shape(animation.mesh.points()) == 1);
  const AMF::Animation_report report = sequence.report();
  CHECK(report.degenerate_rest_triangles == 3);
  CHECK(report.connected_components == 4);
  CHECK(report.border_edges == 4 * 11 + 2 * 3);
  CHECK(report.isolated_vertices == 2);

  AMF::Calibrated_options options;
  options.selection.absolute_threshold = 0;
  Two_stages<Sequence> detector(sequence, options);
  std::vector<Two_stages<Sequence>::Feature> features;
  detector(std::back_inserter(features));
  auto& measured = detector.measurement();
  bool finite = true;
  for (const auto* field : {&measured.strain(), &measured.curvature_change(), &measured.deformation()})
    for (std::size_t v = 0; v < field->number_of_rows(); ++v)
      for (std::size_t f = 0; f < field->number_of_frames(); ++f) finite = finite && std::isfinite((*field)(v, f));
  CHECK(finite);
  std::size_t on_sphere = 0, on_sheet = 0;
  const std::size_t isolated = animation.mesh.number_of_vertices() - 8;
  for (const auto& f : features) {
    double sum = f.time + f.sigma + f.tau + f.response;
    for (int i = 0; i < 3; ++i) sum += f.position[i] + f.rest_position[i] + f.barycentric_coordinates[i];
    CHECK(std::isfinite(sum) && f.sigma > 0 && f.tau > 0 && f.response < 0);
    CHECK(f.vertex_index != isolated && f.vertex_index != isolated + 1);
    on_sphere += f.vertex_index < animation.first_after_sphere;
    on_sheet += f.vertex_index >= animation.first_after_sphere;
  }
  std::cout << on_sphere << " features on the sphere, " << on_sheet << " elsewhere" << std::endl;
  CHECK(on_sphere >= sphere.bumps.size());
  CHECK(on_sheet > 0);
}

// The features of an animation of which further vertices follow those of the sphere.
std::vector<Two_stages<Sequence>::Feature> features_of(const Mesh& mesh, const Frames& frames, double frame_duration,
                                                       AMF::Rest_shape& shape)
{
  const Sequence sequence(mesh, frames, frame_duration);
  shape = sequence.rest_shape();
  Two_stages<Sequence> detector(sequence, AMF::Calibrated_options());
  std::vector<Two_stages<Sequence>::Feature> features;
  detector(std::back_inserter(features));
  return features;
}

// The same, but for the rounding of solves in another order.
void check_equal(const std::vector<Two_stages<Sequence>::Feature>& found,
                 const std::vector<Two_stages<Sequence>::Feature>& expected)
{
  CHECK(found.size() == expected.size());
  for (std::size_t i = 0; i < (std::min)(found.size(), expected.size()); ++i) {
    CHECK(found[i].vertex_index == expected[i].vertex_index && found[i].frame == expected[i].frame);
    CHECK_NEAR(found[i].time, expected[i].time, 1e-6);
    CHECK_NEAR(found[i].sigma, expected[i].sigma, 1e-6 * expected[i].sigma);
    CHECK_NEAR(found[i].tau, expected[i].tau, 1e-6 * expected[i].tau);
    CHECK_NEAR(found[i].response, expected[i].response, 1e-6 * std::abs(expected[i].response));
  }
}

// The size of a shape is that of what deforms: neither a vertex in no triangle nor a part that only moves changes it.
void test_size(const Bumpy_sphere& sphere, const Mesh& mesh)
{
  AMF::Rest_shape alone, shape;
  const auto expected = features_of(mesh, sphere.frames, sphere.frame_duration, alone);
  CHECK(!expected.empty());
  CHECK(alone.measured_vertices().size() == alone.number_of_vertices());
  const auto same_size = [&] {
    return shape.diameter() == alone.diameter() && shape.bounding_box_diagonal() == alone.bounding_box_diagonal() &&
           shape.mean_edge_length() == alone.mean_edge_length() &&
           shape.measured_vertices() == alone.measured_vertices();
  };

  for (const double far : {50., 1e30}) {
    Mesh stray = mesh;
    Frames frames = sphere.frames;
    stray.add_vertex(Point_3(far, far, -far));
    for (std::vector<Point_3>& points : frames) points.emplace_back(far, far, -far);
    const auto found = features_of(stray, frames, sphere.frame_duration, shape);
    CHECK(same_size());
    check_equal(found, expected);
  }

  // A tetrahedron that passes by and turns; its positions are rounded. It is so large that everything is smaller than the
  // smallest scale against it.
  Mesh passing = mesh;
  Frames frames = sphere.frames;
  const std::array<Point_3, 4> corners = {{Point_3(0, 0, 0), Point_3(90, 0, 0), Point_3(0, 90, 0), Point_3(0, 0, 90)}};
  std::vector<Mesh::Vertex_index> v;
  for (const Point_3& p : corners) v.push_back(passing.add_vertex(p));
  for (const auto& t : {std::array<int, 3>{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}})
    passing.add_face(v[std::size_t(t[0])], v[std::size_t(t[1])], v[std::size_t(t[2])]);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const double c = std::cos(0.1 * double(f)), s = std::sin(0.1 * double(f));
    for (const Point_3& p : corners)
      frames[f].emplace_back(float(c * p.x() - s * p.y() + double(f)), float(s * p.x() + c * p.y()), float(p.z()));
  }
  const auto found = features_of(passing, frames, sphere.frame_duration, shape);
  CHECK(same_size());
  check_equal(found, expected);

  // Lengths whose squares overflow say nothing of what deforms; what is then wrong is told by the detection.
  for (const double large : {1e200, -1e308}) {
    Frames overflowing = frames;
    overflowing[3].back() = Point_3(large, large, large);
    const Sequence sequence(passing, overflowing, sphere.frame_duration);
    CHECK(sequence.rest_shape().measured_vertices().size() == sequence.number_of_vertices());
  }

  // where nothing deforms, everything counts
  const Frames still(sphere.frames.size(), frames.front());
  features_of(passing, still, sphere.frame_duration, shape);
  CHECK(shape.measured_vertices().size() == shape.number_of_vertices());
  CHECK(shape.diameter() > 90);
}

// The rows of the rest shape against what their documentation says, found directly. The vertices of the mesh are numbered
// at random, so that nothing is in order by chance.
void test_rest_connectivity(const Bumpy_sphere& sphere)
{
  typedef AMF::Rest_shape::Index Index;
  Unusual_animation animation(sphere);
  std::vector<unsigned> rank(animation.mesh.number_of_vertices());
  std::iota(rank.begin(), rank.end(), 0u);
  std::mt19937 random(3);
  std::shuffle(rank.begin(), rank.end(), random);
  Mesh mesh;
  for (std::size_t v = 0; v < rank.size(); ++v) mesh.add_vertex(Point_3(0, 0, double(v)));
  std::vector<std::array<Mesh::Vertex_index, 3>> triangles;
  for (auto f : faces(animation.mesh)) {
    const auto h = animation.mesh.halfedge(f);
    triangles.push_back(
        {{Mesh::Vertex_index(rank[animation.mesh.source(h)]), Mesh::Vertex_index(rank[animation.mesh.target(h)]),
          Mesh::Vertex_index(rank[animation.mesh.target(animation.mesh.next(h))])}});
  }
  std::shuffle(triangles.begin(), triangles.end(), random);
  for (const auto& t : triangles) mesh.add_face(t[0], t[1], t[2]);
  const AMF::Rest_shape shape(mesh, get(boost::vertex_index, mesh), mesh.number_of_vertices());

  bool good = shape.triangles().size() == triangles.size() && triangles.size() == mesh.number_of_faces();
  std::vector<std::array<Index, 3>> ordered;
  for (std::size_t t = 0; t < triangles.size() && good; ++t) {
    const auto& a = shape.triangles()[t];
    good = a[0] < a[1] && a[0] < a[2];
    bool is_same = false;
    for (int i = 0; i < 3; ++i)
      is_same = is_same ||
                (a[i] == triangles[t][0] && a[(i + 1) % 3] == triangles[t][1] && a[(i + 2) % 3] == triangles[t][2]);
    good = good && is_same;
    ordered.push_back(shape.triangles()[shape.ordered_triangles()[t]]);
  }
  CHECK(good);
  CHECK(std::is_sorted(ordered.begin(), ordered.end()));
  const std::set<std::array<Index, 3>> different(ordered.begin(), ordered.end());
  CHECK(different.size() == triangles.size());

  std::map<std::pair<Index, Index>, Index> thirds; // of the triangle that runs from the first vertex to the second
  for (const auto& t : shape.triangles())
    for (int i = 0; i < 3; ++i) thirds[{t[i], t[(i + 1) % 3]}] = t[(i + 2) % 3];
  const auto third = [&](Index a, Index b) {
    const auto found = thirds.find({a, b});
    return found == thirds.end() ? AMF::Rest_shape::none : found->second;
  };
  std::set<std::pair<Index, Index>> edges;
  for (const auto& e : thirds) edges.insert(std::minmax(e.first.first, e.first.second));
  CHECK(edges.size() == shape.edges().size());
  auto edge = edges.begin();
  good = true;
  for (const AMF::Rest_shape::Edge& e : shape.edges()) {
    good = good && std::make_pair(e.source, e.target) == *edge && e.left == third(e.source, e.target) &&
           e.right == third(e.target, e.source);
    ++edge;
  }
  CHECK(good);

  good = true;
  for (Index v = 0; v < shape.number_of_vertices(); ++v) {
    std::vector<Index> neighbours, at, around;
    for (const auto& e : edges)
      if (e.first == v || e.second == v) neighbours.push_back(e.first == v ? e.second : e.first);
    std::sort(neighbours.begin(), neighbours.end());
    for (Index n : neighbours) at.push_back(Index(std::distance(edges.begin(), edges.find(std::minmax(v, n)))));
    for (Index t : shape.ordered_triangles())
      if (std::count(shape.triangles()[t].begin(), shape.triangles()[t].end(), v) != 0) around.push_back(t);
    const auto same = [](const AMF::Compressed_rows::Row& row, const std::vector<Index>& expected) {
      return std::equal(row.begin(), row.end(), expected.begin(), expected.end());
    };
    bool is_border = false;
    for (Index e : at) is_border = is_border || shape.edges()[e].is_border();
    good = good && same(shape.neighbours()[v], neighbours) && same(shape.incident_edges()[v], at) &&
           same(shape.incident_triangles()[v], around) && shape.is_border(v) == is_border;
  }
  CHECK(good);
}

// Numbers of frames around those that are gathered before they become rows, and more vertices than a piece of them.
template <class FT>
void test_rows()
{
  Mesh mesh;
  const std::size_t n = 2101;
  for (std::size_t v = 0; v < n; ++v) mesh.add_vertex(Point_3(double(v), double(v % 2), 0));
  for (unsigned v = 0; v + 2 < n; ++v)
    mesh.add_face(Mesh::Vertex_index(v), Mesh::Vertex_index(v + 1 + v % 2), Mesh::Vertex_index(v + 2 - v % 2));
  const auto value = [](std::size_t f, std::size_t v, std::size_t c) { return double(f * 4000 + v * 4 + c) / 8; };
  for (std::size_t frames : {3u, 7u, 8u, 9u, 15u, 16u, 17u, 33u}) {
    Frames points(frames);
    AMF::Spatio_temporal_field<FT> fields[3];
    for (auto& field : fields) field = AMF::Spatio_temporal_field<FT>(n, frames);
    for (std::size_t f = 0; f < frames; ++f)
      for (std::size_t v = 0; v < n; ++v) {
        points[f].emplace_back(value(f, v, 0), value(f, v, 1), value(f, v, 2));
        for (std::size_t c = 0; c < 3; ++c) fields[c](v, f) = FT(value(f, v, c));
      }
    const AMF::Frame_sequence<Mesh, FT> a(mesh, points, 1), b(mesh, fields[0], fields[1], fields[2], 1);
    bool good = true;
    for (const auto* s : {&a, &b})
      for (std::size_t v = 0; v < n; ++v)
        for (std::size_t f = 0; f < frames; ++f)
          for (std::size_t c = 0; c < 3; ++c) {
            const auto& x = c == 0 ? s->trajectories().x : c == 1 ? s->trajectories().y : s->trajectories().z;
            good = good && x(v, f) == FT(value(f, v, c));
          }
    CHECK(good);

    // of several, the error of the first vertex is told, and of its first frame
    const FT bad = std::numeric_limits<FT>::quiet_NaN();
    typedef AMF::Frame_sequence<Mesh, FT> Sequence_of_fields;
    const auto make = [&] { return Sequence_of_fields(mesh, fields[0], fields[1], fields[2], 1).number_of_frames(); };
    fields[2](n - 1, frames - 1) = bad;
    CHECK_THROWS(AMF::Input_error, make(), "frame " + std::to_string(frames - 1) + ": the position of vertex 2100 is");
    fields[0](1000, 0) = fields[1](1000, 2) = bad;
    CHECK_THROWS(AMF::Input_error, make(), "frame 0: the position of vertex 1000 is");
    fields[2](999, frames - 1) = bad;
    CHECK_THROWS(AMF::Input_error, make(), "frame " + std::to_string(frames - 1) + ": the position of vertex 999 is");
    fields[1](17, 2) = fields[0](17, 1) = bad;
    CHECK_THROWS(AMF::Input_error, make(), "frame 1: the position of vertex 17 is");
  }
}

int main()
{
  const Bumpy_sphere sphere;
  Mesh mesh;
  add_sphere(sphere, mesh);
  test_positions(sphere, mesh);
  test_views(sphere, mesh);
  test_bad_connectivity(sphere);
  test_bad_frames(sphere, mesh);
  test_rest_shape(sphere, mesh);
  test_unusual(sphere);
  test_size(sphere, mesh);
  test_rest_connectivity(sphere);
  test_rows<float>();
  test_rows<double>();
  return test_result();
}
