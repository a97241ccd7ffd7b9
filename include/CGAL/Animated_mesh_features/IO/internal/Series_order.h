// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_SERIES_ORDER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_SERIES_ORDER_H

#include <CGAL/Animated_mesh_features/IO/internal/Numbered_name.h>
#include <CGAL/Animated_mesh_features/IO/internal/calendar_seconds.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// One way to put names in order: by a number that each of them has.
class Series_order
{
public:
  Series_order(std::vector<long long> values, const char* what)
    : m_what(what)
    , m_values(std::move(values))
    , m_order(m_values.size())
  {
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    std::stable_sort(m_order.begin(), m_order.end(),
                     [&](std::size_t a, std::size_t b) { return m_values[a] < m_values[b]; });
    std::vector<long long> steps;
    for (std::size_t i = 1; i < m_order.size(); ++i) steps.push_back(step_to(i));
    const auto middle = steps.begin() + std::ptrdiff_t((steps.size() - 1) / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    m_usual_step = *middle;
  }

  const std::vector<std::size_t>& order() const { return m_order; } // of the names
  const char* what() const { return m_what; }                       // by which they are in order
  long long usual_step() const { return m_usual_step; }             // in units of the last digit

  // from the name before the i-th in order
  long long step_to(std::size_t i) const { return m_values[m_order[i]] - m_values[m_order[i - 1]]; }

  // The first in order that has the number of the one before it; 0 if there is none.
  std::size_t first_repeated() const
  {
    return first([this](std::size_t i) { return step_to(i) == 0; });
  }

  // The first in order that is not as far from the one before it as others are, but for rounding; 0 if there is none.
  std::size_t first_irregular() const
  {
    // Times are rounded to their last digit, and a thousandth of a step does no harm.
    const long long least_rounded_step = 10;
    const long long tolerance = m_usual_step < least_rounded_step ? 0 : (std::max)(1LL, m_usual_step / 1000);
    return first([&](std::size_t i) { return std::llabs(step_to(i) - m_usual_step) > tolerance; });
  }

private:
  template <class Predicate>
  std::size_t first(const Predicate& is_it) const
  {
    for (std::size_t i = 1; i < m_order.size(); ++i)
      if (is_it(i)) return i;
    return 0;
  }

  const char* m_what;
  std::vector<long long> m_values;
  std::vector<std::size_t> m_order;
  long long m_usual_step;
};

// Names with the same text, as they are read in one form.
typedef std::vector<Numbered_name> Series_names;

// The numbers at a place, for each name.
inline std::vector<Written_number> column(const Series_names& names, std::size_t place)
{
  std::vector<Written_number> numbers;
  for (const Numbered_name& n : names) numbers.push_back(n.numbers[place]);
  return numbers;
}

// The places at which not all names have the same number.
inline std::vector<std::size_t> varying_places(const Series_names& names)
{
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < names.front().numbers.size(); ++i)
    if (std::any_of(names.begin(), names.end(), [&](const Numbered_name& n) {
          const Written_number &a = n.numbers[i], &b = names.front().numbers[i];
          return a.digits != b.digits || a.exponent != b.exponent || a.sign != b.sign;
        }))
      places.push_back(i);
  return places;
}

// The seconds of the date that each name has from field `first` on; nothing if any of them has none there.
inline std::optional<std::vector<long long>> dates(const Series_names& names, Date_order order, std::size_t first)
{
  std::vector<long long> seconds;
  std::size_t end = 0, end_of_front = 0;
  for (const Numbered_name& n : names) {
    std::vector<std::string> digits;
    for (const Written_number& number : n.numbers) digits.push_back(number.digits);
    const std::optional<long long> s = calendar_seconds(calendar_fields(digits), first, order, end);
    if (seconds.empty()) end_of_front = end;
    if (!s || end != end_of_front) return std::nullopt;
    seconds.push_back(*s);
  }
  return seconds;
}

// All orders in which names with the same text, in one form, may be meant. Those of whole numbers have dates as well.
inline void append_orders(const Series_names& names, Number_form form, std::vector<Series_order>& orders)
{
  const char* const what[] = {"whole numbers", "numbers with signs", "decimal numbers", "numbers with exponents"};
  for (std::size_t place : varying_places(names))
    if (auto v = values(column(names, place))) orders.emplace_back(std::move(*v), what[int(form)]);
  if (form != Number_form::WHOLE) return;
  const std::size_t most_fields = 6 * names.front().numbers.size();
  for (const auto& date : {std::make_pair(Date_order::YEAR_MONTH_DAY, "dates (year, month, day)"),
                           std::make_pair(Date_order::DAY_MONTH_YEAR, "dates (day, month, year)"),
                           std::make_pair(Date_order::MONTH_DAY_YEAR, "dates (month, day, year)")})
    for (std::size_t first = 0; first < most_fields; ++first)
      if (auto v = dates(names, date.first, first)) orders.emplace_back(std::move(*v), date.second);
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_SERIES_ORDER_H
