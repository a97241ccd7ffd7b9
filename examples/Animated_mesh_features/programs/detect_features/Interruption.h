// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_INTERRUPTION_H
#define DETECT_FEATURES_INTERRUPTION_H

#include <csignal>

namespace Detect_features {

namespace internal {

inline volatile std::sig_atomic_t received_signal = 0;

inline void receive_signal(int signal)
{
  received_signal = signal;
}

} // namespace internal

// Turns the signals that ask a program to end into a flag, so that it ends by an exception and removes its temporary
// files. A signal that is ignored already, as those of a program in the background are, stays ignored.
class Interruption
{
public:
  Interruption()
  {
    catch_signal(SIGINT);
    catch_signal(SIGTERM);
#ifndef _WIN32
    catch_signal(SIGHUP);
    // A reader that goes away is an error of writing like any other.
    std::signal(SIGPIPE, SIG_IGN);
#endif
  }

  // The signal that was received, or 0.
  static int signal()
  {
    return int(internal::received_signal);
  }

private:
  static void catch_signal(int signal)
  {
#ifdef _WIN32
    std::signal(signal, internal::receive_signal);
#else
    struct sigaction old;
    if (sigaction(signal, nullptr, &old) != 0 || old.sa_handler == SIG_IGN) return;
    struct sigaction action = {};
    action.sa_handler = internal::receive_signal; // without SA_RESTART: waiting for the reader of a pipe ends as well
    sigaction(signal, &action, nullptr);
#endif
  }
};

} // namespace Detect_features

#endif // DETECT_FEATURES_INTERRUPTION_H
