// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Animated_mesh_features/Spatio_temporal_field.h>

#include <cstdlib>
#include <iostream>

#ifndef CGAL_EIGEN3_ENABLED
  #error "CGAL is not told of Eigen"
#endif

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/parallel_for.h>
#endif

// in the other translation unit: a header with a function that is not inline would not link
double sum_of_field(const CGAL::Animated_mesh_features::Spatio_temporal_field<double>& field);

int main()
{
  CGAL::Animated_mesh_features::Spatio_temporal_field<double> field(3, 4);
#ifdef CGAL_LINKED_WITH_TBB
  const bool with_tbb = true;
  tbb::parallel_for(std::size_t(0), field.number_of_rows(), [&](std::size_t row) { field(row, 1) = double(row); });
#else
  const bool with_tbb = false;
  for (std::size_t row = 0; row < field.number_of_rows(); ++row) field(row, 1) = double(row);
#endif
  if (with_tbb != bool(EXPECT_TBB)) {
    std::cerr << "with TBB: " << with_tbb << ", expected: " << EXPECT_TBB << std::endl;
    return EXIT_FAILURE;
  }
  if (sum_of_field(field) != 3.) {
    std::cerr << "the field's sum is wrong" << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
