// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Animations so long that F x F numbers would be too many: the weights of temporal filters by distance against their
// matrices, Gaussians with weights every few frames against the discrete cosine transform, and the extrema of a long field
// against those that are found with matrices, and sample by sample. All of it also of cyclic animations.

#include "test_shapes.h"

#include <CGAL/Animated_mesh_features/Extrema/find_response_extrema.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Temporal_weights.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Time_axis.h>
#include <CGAL/Animated_mesh_features/Scale_space/Box_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Gaussian_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/One_ring_average_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/is_periodic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;
using namespace test_support;
typedef std::vector<double> Row;

const double frame_duration = 1. / 30;
const Amf::Boundary_condition cyclic = Amf::Boundary_condition::PERIODIC;

// The filter without what it tells of long rows.
template <class Filter>
class Filter_with_matrices
{
public:
  static constexpr bool vectorized = true;

  explicit Filter_with_matrices(const Filter& filter = Filter())
    : m_filter(filter)
  {}
  void initialize(std::size_t frames, double duration, const Row& variances)
  {
    m_filter.initialize(frames, duration, variances);
  }
  double variance(std::size_t l) const { return m_filter.variance(l); }
  bool has_equal_steps() const { return m_filter.has_equal_steps(); }
  bool is_periodic() const { return m_filter.is_periodic(); }
  template <class T>
  void operator()(std::size_t l, const T* in, T* out) const
  {
    m_filter(l, in, out);
  }

private:
  Filter m_filter;
};

// The same minima, of which the search does not say that they are strict: all samples are looked at in double precision,
// one after the other.
struct Minima_sample_by_sample : Amf::Difference_of_gaussians_minima
{
  static constexpr bool strict_minima = false;
};

Row squared_seconds(const Row& squared_frames)
{
  Row result;
  for (double u : squared_frames) result.push_back(u * frame_duration * frame_duration);
  return result;
}

// All rows of all levels, made of weights by distance, against matrices of the same filter.
template <class Filter>
void test_rows(const std::string& name, Filter filter, std::size_t frames, const Row& variances)
{
  filter.initialize(frames, frame_duration, squared_seconds(variances));
  CHECK(filter.reflects() != filter.is_periodic() && Amf::is_periodic(filter) == filter.is_periodic());
  const Amf::internal::Time_axis axis(frames, filter);
  const std::size_t margin = filter.is_periodic() ? 0 : 1;
  const std::size_t levels = variances.size();
  Amf::internal::Temporal_weights<Filter> matrices(filter, frames, levels, levels),
      by_distance(filter, frames, levels, levels, 0);
  CHECK(by_distance.window_size() == levels);
  Amf::Default_visitor visitor;
  const Amf::Task_loop<CGAL::Sequential_tag, Amf::Default_visitor> loop(visitor, Amf::Stage::EXTREMA);
  matrices.set_window(0, levels, loop);
  by_distance.set_window(0, levels, loop);
  typename Amf::internal::Temporal_weights<Filter>::Rows a(matrices), b(by_distance);
  double largest = 0;
  for (std::size_t centre = margin; centre + margin < frames; ++centre)
    for (std::size_t l = 0; l < levels; ++l) {
      a.seek(0, l + 1, centre);
      b.seek(0, l + 1, centre);
      CHECK(a.begin() == 0 && a.end() == frames);
      for (std::size_t f : {axis.before(centre), centre, axis.after(centre)})
        for (std::size_t j = 0; j < frames; ++j) {
          const double weight = j >= b.begin() && j < b.end() ? b.row(l, f)[j - b.begin()] : 0;
          largest = (std::max)(largest, std::abs(weight - a.row(l, f)[j]));
        }
    }
  std::cout << name << ", " << frames << " frames: weights differ by " << largest << std::endl;
  CHECK(largest < 1e-15);
}

void test_all_rows()
{
  for (std::size_t frames : {3, 4, 17, 64, 129}) {
    // from hardly anything to what reaches around several times
    for (const Amf::Boundary_condition ends : {Amf::Boundary_condition::REFLECT, cyclic}) {
      test_rows("Gaussian", Amf::Gaussian_temporal_filter(ends), frames, {0.01, 0.5, 3, 20, 150, 2000});
      for (std::size_t width : {2, 3, 6, 9}) {
        const Amf::Box_temporal_filter box(width, ends);
        const double unit = box.unit_variance(frames, frame_duration) / (frame_duration * frame_duration);
        test_rows("boxes of " + std::to_string(width), box, frames, {0, unit, 2 * unit, 5 * unit, 9 * unit});
      }
      test_rows("boxes that fit", Amf::Box_temporal_filter(0, ends), frames, {0.1, 0.5, 3, 20, 150});
    }
  }
  CHECK_THROWS(Amf::Option_error, Amf::Gaussian_temporal_filter(Amf::Boundary_condition::TRUNCATE), "boxes only");
  CHECK(!Amf::Box_temporal_filter(3, Amf::Boundary_condition::REPLICATE).reflects());
  CHECK(!Amf::Box_temporal_filter(3, Amf::Boundary_condition::TRUNCATE).reflects());
}

// Levels of a long row of noise against their definition in the basis of the DCT-II, whose factors are
// exp(u (cos(pi j / F) - 1)), at some frames.
template <class FT>
void test_long_gaussian(double bound)
{
  constexpr std::size_t n = 1500;
  // cos(pi i / (2 n)), with the whole turns taken off before anything is rounded
  typedef long double Exact; // sums of as many terms as there are frames
  const auto cosine = [](std::size_t i) { return std::cos(std::acos(Exact(-1)) * Exact(i % (4 * n)) / (2 * n)); };
  Row variances;
  for (double tau = 0.7; tau < 3 * double(n); tau *= 1.26) // from some level on the weights reach around the mirror images
    variances.push_back(tau * tau);
  Amf::Gaussian_temporal_filter filter;
  filter.initialize(n, frame_duration, squared_seconds(variances));
  Random random(7);
  std::vector<FT> row(n), next(n);
  for (FT& x : row) x = FT(random());
  std::vector<Exact> coefficients(n); // of the row, with the factors of the inverse
  for (std::size_t j = 0; j < n; ++j) {
    Exact sum = 0;
    for (std::size_t f = 0; f < n; ++f) sum += Exact(row[f]) * cosine(j * (2 * f + 1));
    coefficients[j] = sum * (j == 0 ? 1 : 2) / n;
  }
  double largest = 0;
  for (std::size_t l = 0; l < variances.size(); ++l) {
    filter(l, row.data(), next.data());
    row.swap(next);
    for (std::size_t f : {std::size_t(0), std::size_t(1), std::size_t(200), n / 2, n - 1}) {
      Exact exact = 0;
      for (std::size_t j = 0; j < n; ++j)
        exact += coefficients[j] * std::exp(Exact(variances[l]) * (cosine(2 * j) - 1)) * cosine(j * (2 * f + 1));
      largest = (std::max)(largest, double(std::abs(exact - Exact(row[f]))));
    }
  }
  std::cout << variances.size() << " levels of a row of " << n << " frames differ by " << largest << std::endl;
  CHECK(largest < bound);
}

// The same of cyclic rows against the heat kernel of the circle, whose factors in the Fourier basis are
// exp(u (cos(2 pi j / F) - 1)).
template <class FT>
void test_cyclic_gaussian(std::size_t n, double bound)
{
  typedef long double Exact;
  std::vector<Exact> cosines(n);
  for (std::size_t i = 0; i < n; ++i) cosines[i] = std::cos(2 * std::acos(Exact(-1)) * Exact(i) / Exact(n));
  Row variances;
  for (double tau = 0.7; tau < double(n); tau *= 1.26) variances.push_back(tau * tau);
  Amf::Gaussian_temporal_filter filter(cyclic);
  filter.initialize(n, frame_duration, squared_seconds(variances));
  Random random(5);
  std::vector<FT> row(n), next(n);
  for (FT& x : row) x = FT(random());
  const std::vector<FT> unsmoothed = row;
  const std::vector<std::size_t> frames = {0, 1, n / 2, n - 1};
  // for each of these frames and each wave, the sum of the row times the cosine of the wave around the frame
  std::vector<std::vector<Exact>> waves(frames.size(), std::vector<Exact>(n, 0));
  for (std::size_t i = 0; i < frames.size(); ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t f = 0; f < n; ++f) waves[i][j] += Exact(unsmoothed[f]) * cosines[j * (f + n - frames[i]) % n];
  double largest = 0;
  for (std::size_t l = 0; l < variances.size(); ++l) {
    filter(l, row.data(), next.data());
    row.swap(next);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      Exact exact = 0;
      for (std::size_t j = 0; j < n; ++j)
        exact += std::exp(Exact(variances[l]) * (cosines[j] - 1)) * waves[i][j] / Exact(n);
      largest = (std::max)(largest, double(std::abs(exact - Exact(row[frames[i]]))));
    }
  }
  std::cout << variances.size() << " levels of a cyclic row of " << n << " frames differ by " << largest << std::endl;
  CHECK(largest < bound);
}

// A row that is turned round comes out turned round, to the last bit: what matrices of Gaussians are completed by.
void test_mirror_symmetry(Amf::Boundary_condition ends)
{
  Random random(11);
  for (std::size_t frames : {3, 8, 65, 300}) {
    Amf::Gaussian_temporal_filter filter(ends);
    filter.initialize(frames, frame_duration, squared_seconds({0.3, 2, 9, 300, 90000}));
    Row row(frames);
    for (double& x : row) x = random();
    Row turned(row.rbegin(), row.rend()), next(frames), next_turned(frames);
    for (std::size_t l = 0; l < 5; ++l) {
      filter(l, row.data(), next.data());
      filter(l, turned.data(), next_turned.data());
      CHECK((l == 4 || next != row) && std::equal(next.begin(), next.end(), next_turned.rbegin()));
      row.swap(next);
      turned.swap(next_turned);
    }
  }
}

// Seven levels in space, and those in time that it is told.
struct Levels
{
  Row time;

  template <class SpatialFilter, class TemporalFilter>
  Amf::Scale_levels operator()(const Amf::Rest_shape&, std::size_t, double, const SpatialFilter&,
                               const TemporalFilter&) const
  {
    Amf::Scale_levels levels;
    for (std::size_t k = 0; k < 7; ++k) levels.space_variances.push_back(0.3 * std::pow(2, double(k)));
    levels.time_variances = time;
    return levels;
  }
};

void check_same(const std::vector<Amf::Response_extremum>& found, const std::vector<Amf::Response_extremum>& expected,
                double bound)
{
  CHECK(found.size() == expected.size());
  double largest = 0;
  for (std::size_t i = 0; i < (std::min)(found.size(), expected.size()); ++i) {
    const auto &a = found[i], &b = expected[i];
    CHECK(a.vertex == b.vertex && a.frame == b.frame && a.at_scale_limit == b.at_scale_limit);
    for (double difference : {a.response - b.response, (a.sigma - b.sigma) / b.sigma, (a.tau - b.tau) / b.tau,
                              a.refined_frame - b.refined_frame})
      largest = (std::max)(largest, std::abs(difference));
  }
  std::cout << "which differ by " << largest << std::endl;
  CHECK(largest <= bound);
}

typedef Amf::Spatio_temporal_field<double> Field;
typedef std::vector<Amf::Response_extremum> Extrema;

void sort(Extrema& extrema)
{
  std::sort(extrema.begin(), extrema.end(), [](const auto& a, const auto& b) {
    return std::tie(a.vertex, a.frame, a.tau, a.sigma) < std::tie(b.vertex, b.frame, b.tau, b.sigma);
  });
}

template <class Filter, class Search>
Extrema extrema_of(const Amf::Rest_shape& shape, const Field& field, const Filter& filter, const Search& search,
                   const Row& time_variances)
{
  Amf::Extremum_options<Amf::One_ring_average_filter, Filter, Levels, Amf::Central_difference_of_gaussians, Search>
      options;
  options.temporal_filter = filter;
  options.sampling.time = squared_seconds(time_variances);
  options.search = search;
  Amf::Default_visitor visitor;
  Extrema result = Amf::find_response_extrema(shape, field, frame_duration, options, 0, visitor).extrema;
  sort(result);
  return result;
}

// Noise, with a slow wave.
Field noise_on(const Shape& plane, std::size_t frames, double frequency)
{
  Random random(3);
  Field field(plane.points.size(), frames);
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < frames; ++f)
      field(v, f) = random() + 3 * std::sin(frequency * double(f) + plane.points[v][0]) * std::cos(plane.points[v][1]);
  return field;
}

// The extrema of noise, most of them at the smallest scales, with a slow wave for the largest.
template <class Filter>
void test_extrema(const Filter& temporal, const Row& time_variances, std::size_t least_number)
{
  const Shape plane = regular_plane(5, 5);
  const Amf::Rest_shape shape = rest_shape_of(plane);
  const Field field = noise_on(plane, 1400, 0.01);
  const auto extrema = [&](const auto& filter, const auto& search) {
    return extrema_of(shape, field, filter, search, time_variances);
  };
  const Amf::Difference_of_gaussians_minima minima;
  const std::vector<Amf::Response_extremum> found = extrema(temporal, minima);
  std::cout << found.size() << " extrema" << std::endl;
  CHECK(found.size() > least_number);
  check_same(found, extrema(Filter_with_matrices<Filter>(temporal), minima), 1e-9);
  check_same(found, extrema(temporal, Minima_sample_by_sample()), 0);
}

int main()
{
  test_all_rows();
  test_mirror_symmetry(Amf::Boundary_condition::REFLECT);
  test_mirror_symmetry(cyclic);
  test_long_gaussian<double>(1e-14);
  test_long_gaussian<float>(3e-6);
  for (std::size_t frames : {7, 48, 1500}) {
    test_cyclic_gaussian<double>(frames, 1e-14);
    test_cyclic_gaussian<float>(frames, 3e-6);
  }
  Row gaussian;
  for (double tau = 0.8; tau < 300; tau *= 1.26) gaussian.push_back(tau * tau);
  test_extrema(Amf::Gaussian_temporal_filter(), gaussian, 50);
  test_extrema(Amf::Gaussian_temporal_filter(cyclic), gaussian, 50);
  const Amf::Box_temporal_filter box(5);
  const double unit = box.unit_variance(1400, frame_duration) / (frame_duration * frame_duration);
  Row boxes;
  for (std::size_t l = 1; l <= 12; ++l) boxes.push_back(double(l) * unit);
  test_extrema(box, boxes, 10);
  test_extrema(Amf::Box_temporal_filter(5, cyclic), boxes, 10);
  return test_result();
}
