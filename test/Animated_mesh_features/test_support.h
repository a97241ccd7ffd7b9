// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_TEST_SUPPORT_H
#define CGAL_ANIMATED_MESH_FEATURES_TEST_SUPPORT_H

#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

// Checks that hold in every build type: a failed one is counted and reported with its values, the test goes on, and
// test_result() makes main() fail.

namespace test_support {

inline int& failures()
{
  static int n = 0;
  return n;
}

inline int& checks()
{
  static int n = 0;
  return n;
}

inline void report(bool ok, const char* file, int line, const std::string& what)
{
  ++checks();
  if (ok) return;
  ++failures();
  std::cerr << file << ":" << line << ": failed: " << what << std::endl;
}

template <class A, class B>
void check_near(A a, B b, double tolerance, const char* what, const char* file, int line)
{
  // written so that a NaN fails
  const bool ok = std::abs(double(a) - double(b)) <= tolerance;
  report(ok, file, line,
         std::string(what) + ": " + std::to_string(double(a)) + " against " + std::to_string(double(b)) +
             ", tolerance " + std::to_string(tolerance));
}

template <class Exception, class Function>
void check_throws(Function f, const std::string& part_of_message, const char* file, int line)
{
  try {
    f();
    report(false, file, line, "no exception, expected one with \"" + part_of_message + "\"");
  } catch (const Exception& e) {
    report(std::string(e.what()).find(part_of_message) != std::string::npos, file, line,
           "message \"" + std::string(e.what()) + "\" lacks \"" + part_of_message + "\"");
  } catch (const std::exception& e) {
    report(false, file, line, std::string("another exception: ") + e.what());
  }
}

// The exit code by which CTest knows a test that could not run here (SKIP_RETURN_CODE).
constexpr int skipped = 77;

// To be returned by main(). A test that checked nothing is a failure.
inline int test_result()
{
  std::cout << checks() << " checks, " << failures() << " failed" << std::endl;
  return (failures() == 0 && checks() > 0) ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace test_support

#define CHECK(condition) test_support::report(bool(condition), __FILE__, __LINE__, #condition)
#define CHECK_NEAR(a, b, tolerance)                                                                                    \
  test_support::check_near((a), (b), (tolerance), #a " == " #b, __FILE__, __LINE__)
#define CHECK_THROWS(Exception, expression, part_of_message)                                                           \
  test_support::check_throws<Exception>([&] { (void)(expression); }, part_of_message, __FILE__, __LINE__)

#endif // CGAL_ANIMATED_MESH_FEATURES_TEST_SUPPORT_H
