// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RUNNING_INTERRUPTION_H
#define PROGRAMS_RUNNING_INTERRUPTION_H

namespace Programs {

// Turns the signals that ask a program to end into a flag, so that it ends by an exception and removes its temporary
// files; the second one of a kind ends it at once. A signal that is ignored already, as those of a program in the
// background are, stays ignored.
class Interruption
{
public:
  Interruption();

  // The signal that was received, or 0.
  static int signal();

  // throws Cancelled if a signal was received.
  static void check();
};

} // namespace Programs

#endif // PROGRAMS_RUNNING_INTERRUPTION_H
