// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "running/run_program.h"

#include "running/Interruption.h"
#include "running/tell.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/config.h>

#include <csignal>
#include <exception>
#include <iostream>
#include <new>

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

namespace {

int failed(const std::string& name, const std::string& message, int exit_code)
{
  // Waiting for the reader of a pipe ends by an error, too.
  if (Interruption::signal() != 0) {
    tell(name + ": interrupted\n");
    return INTERRUPTED + Interruption::signal();
  }
  tell(name + ": " + message + "\n");
  if (exit_code == BAD_USAGE) tell("Try " + name + " --help\n");
  return exit_code;
}

} // namespace

int run_program(const std::string& name, const std::function<void()>& run)
{
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN); // a file that becomes too large is an error of writing like any other
#endif
  try {
    run();
    return std::cout ? SUCCESS : CANNOT_WRITE;
  } catch (const AMF::Option_error& e) {
    return failed(name, e.what(), BAD_USAGE);
  } catch (const AMF::Input_error& e) {
    return failed(name, e.what(), BAD_INPUT);
  } catch (const AMF::Output_error& e) {
    return failed(name, e.what(), CANNOT_WRITE);
  } catch (const std::bad_alloc&) {
    return failed(name, "out of memory", FAILURE);
  } catch (const std::exception& e) {
    return failed(name, e.what(), FAILURE);
  }
}

std::string version_line(const std::string& name)
{
  return name + " " + ANIMATED_MESH_FEATURES_VERSION + " (CGAL " + CGAL_VERSION_STR +
#ifdef CGAL_LINKED_WITH_TBB
         ", with oneTBB)\n";
#else
         ", without oneTBB: one thread)\n";
#endif
}

} // namespace Programs
