// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_NUMBERED_SERIES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_NUMBERED_SERIES_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/internal/Series_order.h>
#include <CGAL/Animated_mesh_features/IO/natural_order.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

The frames of an animation among files, in their order: see `numbered_series()`.
*/
struct Numbered_series
{
  /// the frames, in the order of their numbers.
  std::vector<std::string> files;

  /// what does not belong to the series, in `natural_order()`.
  std::vector<std::string> others;

  /// how the names were read, if that was not as whole numbers: "decimal numbers", say.
  std::string reading;
};

namespace internal {

inline std::string remedy_for_names()
{
  return "; if the names do not tell the order, give the frames one by one with the option frames_as_given (command "
         "line: --as-given)";
}

inline std::string file_name(const std::string& path)
{
  return std::filesystem::path(path).filename().string();
}

// What is compared: the whole path, but for the ending.
inline Series_names series_names(const std::vector<std::string>& files, Number_form form)
{
  Series_names names;
  const bool are_after_hyphens = std::any_of(files.begin(), files.end(), has_hyphen_before_sign);
  for (const std::string& file : files) {
    const std::filesystem::path path = std::filesystem::path(file).lexically_normal();
    names.push_back(numbered_name((path.parent_path() / path.stem()).string(), form, are_after_hyphens));
  }
  return names;
}

typedef std::vector<std::vector<std::string>> File_groups;

// Files whose names have the same text, the larger group first.
inline File_groups groups_by_text(const std::vector<std::string>& files, Number_form form)
{
  std::map<std::string, std::vector<std::string>> by_text;
  const Series_names names = series_names(files, form);
  for (std::size_t i = 0; i < files.size(); ++i) by_text[names[i].text].push_back(files[i]);
  File_groups groups;
  for (auto& group : by_text) groups.push_back(std::move(group.second));
  std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return groups;
}

constexpr Number_form number_forms[] = {Number_form::WHOLE, Number_form::SIGNED, Number_form::DECIMAL,
                                        Number_form::SCIENTIFIC};

// The same in the form in which most names have the same text; the simplest one of several.
inline File_groups largest_series(const std::vector<std::string>& files)
{
  File_groups largest;
  for (Number_form form : number_forms) {
    File_groups groups = groups_by_text(files, form);
    if (largest.empty() || groups[0].size() > largest[0].size()) largest = std::move(groups);
  }
  return largest;
}

// The orders that the names may mean; none unless in some form they differ in numbers only.
inline std::vector<Series_order> possible_orders(const std::vector<std::string>& files)
{
  std::vector<Series_order> orders;
  for (Number_form form : number_forms) {
    const Series_names names = series_names(files, form);
    const bool is_one =
        std::all_of(names.begin(), names.end(), [&](const Numbered_name& n) { return n.text == names.front().text; });
    if (is_one) append_orders(names, form, orders);
  }
  return orders;
}

[[noreturn]] inline void throw_repeated(const std::vector<std::string>& files, const std::vector<Series_order>& orders)
{
  // the last number of a name counts its frames, others tell series apart
  std::size_t last = 0;
  while (last + 1 < orders.size() && orders[last + 1].what() == orders[0].what()) ++last;
  const Series_order& order = orders[last];
  const std::size_t i = order.first_repeated();
  throw Input_error(files[order.order()[i]] + ": has the same number as " + file_name(files[order.order()[i - 1]]) +
                    ": a copy, or the frame of another series" + remedy_for_names());
}

[[noreturn]] inline void throw_irregular(const std::vector<std::string>& files, const Series_order& order)
{
  const std::size_t i = order.first_irregular();
  const long long step = order.step_to(i), usual = order.usual_step();
  std::string message = files[order.order()[i]] + ": follows " + file_name(files[order.order()[i - 1]]);
  if (step > usual && step % usual == 0)
    message += ", but " + std::to_string(step / usual - 1) + " of the series " + (step == 2 * usual ? "is" : "are") +
               " missing between them";
  else
    message += " at another distance than most frames follow each other";
  throw Input_error(message + ": frames must be equidistant in time" + remedy_for_names());
}

// The order that is meant: equidistant numbers if there are any; all that are must agree.
inline Series_order meant_order(const std::vector<std::string>& files)
{
  const std::vector<Series_order> orders = possible_orders(files);
  if (orders.empty())
    throw Input_error(files.front() + ": its name has no number that tells its place among the frames" +
                      remedy_for_names());
  const Series_order* meant = nullptr;
  for (bool is_regular : {true, false})
    for (const Series_order& order : orders) {
      const bool is_of_kind = order.first_repeated() == 0 && (order.first_irregular() == 0) == is_regular;
      if (!is_of_kind || (meant != nullptr && meant->order() == order.order())) continue;
      if (meant == nullptr)
        meant = &order;
      else if ((meant->first_irregular() == 0) == is_regular)
        throw Input_error(files[meant->order()[0]] + ": is the first frame if names are read as " + meant->what() +
                          (meant->order()[0] == order.order()[0]
                               ? ", and so in another order if as "
                               : ", but " + file_name(files[order.order()[0]]) + " is if as ") +
                          order.what() + ": two orders are possible" + remedy_for_names());
    }
  if (meant == nullptr) throw_repeated(files, orders);
  if (meant->first_irregular() != 0) throw_irregular(files, *meant);
  return *meant;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesReading

puts the files of the frames of an animation in order. Their names differ in a number, which may have leading zeros, a
sign, a fraction, an exponent, or be a date with or without a time of day. A name is read in all of these ways
(`sim-1` is number 1, or -1 where others are `sim0` and `sim1`), and the way is taken in which the numbers are
equidistant, as frames are: each number once, none missing, to within the rounding of the last digit. Case of
letters and the ending do not matter.

Linear in the number of files, but for sorting.

\param files at least two
\param leave_others_out what to do with files whose names have another text than those of all others: leave them
  out (a template among the frames, a copy `f3 (1).obj`), or refuse. Two files alike are another series, which is
  refused in any case.
\throws Input_error if the names are no such series, or two in different order; the message names the file.
*/
inline Numbered_series numbered_series(std::vector<std::string> files, bool leave_others_out)
{
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return natural_order(a, b); });
  const auto twice = std::adjacent_find(files.begin(), files.end());
  if (twice != files.end()) throw Input_error(*twice + ": is given twice");
  Numbered_series series;
  const internal::File_groups groups = internal::largest_series(files);
  if (groups.size() > 1) {
    const std::vector<std::string>& main = groups[0];
    const std::string main_text = "the series of " + internal::file_name(main[0]) + " (" + std::to_string(main.size()) +
                                  (main.size() == 1 ? " file)" : " files)");
    if (groups[1].size() > 1)
      throw Input_error(groups[1][0] + ": is one of " + std::to_string(groups[1].size()) +
                        " files of another series than " + main_text + "; which ones are the frames?" +
                        internal::remedy_for_names());
    if (!leave_others_out || main.size() == 1)
      throw Input_error(groups[1][0] + ": its name does not belong to " + main_text + internal::remedy_for_names());
    for (auto other = groups.begin() + 1; other != groups.end(); ++other) series.others.push_back(other->front());
    files = main;
  }
  const internal::Series_order order = internal::meant_order(files);
  if (std::string(order.what()) != "whole numbers") series.reading = order.what();
  for (std::size_t i : order.order()) series.files.push_back(files[i]);
  return series;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_NUMBERED_SERIES_H
