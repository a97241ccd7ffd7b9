// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_FEATURES_TEST_TBB_PARALLEL_FOR_H
#define ANIMATED_MESH_FEATURES_TEST_TBB_PARALLEL_FOR_H

#include "blocked_range.h"
#include "threads.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace tbb {

// The portions of the range are dealt out to the threads in turn: each of them gets work, however soon the first one would
// be done with all, and nothing orders what they do, so that ThreadSanitizer sees every race. A loop within a loop runs
// on one thread.
template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body)
{
  if (range.empty()) return;
  if (test::in_loop()) {
    body(range);
    return;
  }

  const std::size_t size = std::size_t(range.end() - range.begin());
  const int allowed = test::allowed_threads();
  const std::size_t portion = (std::max)(range.grainsize(), size / (8 * std::size_t(allowed)));
  std::array<std::exception_ptr, test::number_of_threads> errors;

  const auto work = [&](int rank) {
    test::rank() = rank;
    test::in_loop() = true;
    try {
      for (std::size_t first = std::size_t(rank) * portion; first < size; first += std::size_t(allowed) * portion) {
        const std::size_t last = (std::min)(size, first + portion);
        const Body own(body); // as TBB does
        own(blocked_range<Value>(range.begin() + Value(first), range.begin() + Value(last), range.grainsize()));
      }
    } catch (...) {
      errors[std::size_t(rank)] = std::current_exception();
    }
    test::in_loop() = false;
    test::rank() = 0;
  };

  std::vector<std::thread> threads;
  for (int rank = 1; rank < allowed; ++rank) threads.emplace_back(work, rank);
  work(0);
  for (std::thread& t : threads) t.join();
  for (const std::exception_ptr& e : errors)
    if (e) std::rethrow_exception(e);
}

} // namespace tbb

#endif // ANIMATED_MESH_FEATURES_TEST_TBB_PARALLEL_FOR_H
