// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "options/suggestion.h"

#include <algorithm>
#include <cstddef>

namespace Programs {

namespace {

// The optimal string alignment distance: of Levenshtein's, with swaps of neighbours.
std::size_t distance(const std::string& a, const std::string& b)
{
  const std::size_t n = b.size();
  std::vector<std::size_t> before_last(n + 1), last(n + 1), current(n + 1);
  for (std::size_t j = 0; j <= n; ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= n; ++j) {
      const std::size_t change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      current[j] = (std::min)({change, last[j] + 1, current[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        current[j] = (std::min)(current[j], before_last[j - 2] + 1);
    }
    before_last.swap(last);
    last.swap(current);
  }
  return last[n];
}

} // namespace

std::string probable_word(const std::string& word, const std::vector<std::string>& known)
{
  if (word.empty()) return "";
  const auto begins_with_it = [&](const std::string& k) { return k.compare(0, word.size(), word) == 0; };
  if (std::count_if(known.begin(), known.end(), begins_with_it) == 1)
    return *std::find_if(known.begin(), known.end(), begins_with_it);
  std::string nearest;
  std::size_t least = (std::max<std::size_t>)(word.size() / 3, 1) + 1;
  for (const std::string& k : known) {
    const std::size_t d = distance(word, k);
    if (d >= least) continue;
    least = d;
    nearest = k;
  }
  return nearest;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known)
{
  const std::string probable = probable_word(word, known);
  return probable.empty() ? "" : "; did you mean " + probable + "?";
}

} // namespace Programs
