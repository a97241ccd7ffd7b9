// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "running/Interruption.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <csignal>

namespace Programs {

namespace {

volatile std::sig_atomic_t received_signal = 0;

void receive_signal(int signal)
{
  received_signal = signal;
}

void catch_signal(int signal)
{
#ifdef _WIN32
  std::signal(signal, receive_signal);
#else
  struct sigaction old;
  if (sigaction(signal, nullptr, &old) != 0 || old.sa_handler == SIG_IGN) return;
  struct sigaction action = {};
  action.sa_handler = receive_signal; // without SA_RESTART: waiting for the reader of a pipe ends as well
  action.sa_flags = SA_RESETHAND; // who asks for it twice does not want to wait; the next run removes what is left
  sigaction(signal, &action, nullptr);
#endif
}

} // namespace

Interruption::Interruption()
{
  catch_signal(SIGINT);
  catch_signal(SIGTERM);
#ifndef _WIN32
  catch_signal(SIGHUP);
  // A reader that goes away is an error of writing like any other.
  std::signal(SIGPIPE, SIG_IGN);
#endif
}

int Interruption::signal()
{
  return int(received_signal);
}

void Interruption::check()
{
  if (signal() != 0) throw CGAL::Animated_mesh_features::Cancelled();
}

} // namespace Programs
