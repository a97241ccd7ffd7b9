// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "running/Stage_log.h"

#ifndef _WIN32
  #include <sys/resource.h>
#endif

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace Programs {

namespace {

// The largest memory that the program has had so far (bytes); 0 if it is not known.
std::size_t peak_memory()
{
#ifdef _WIN32
  return 0;
#else
  rusage usage;
  if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
  #ifdef __APPLE__
  return std::size_t(usage.ru_maxrss);
  #else
  return std::size_t(usage.ru_maxrss) * 1024;
  #endif
#endif
}

} // namespace

void Stage_log::begin(const std::string& name)
{
  if (!m_open.empty()) count_for_innermost();
  const auto entry =
      std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& e) { return e.name == name; });
  m_open.push_back(std::size_t(entry - m_entries.begin()));
  if (entry == m_entries.end()) m_entries.push_back({name, 0, 0});
  m_timer.reset();
  m_timer.start();
}

void Stage_log::end()
{
  count_for_innermost();
  m_open.pop_back();
  if (!m_open.empty()) m_timer.start();
}

double Stage_log::seconds(const std::string& name) const
{
  for (const Entry& e : m_entries)
    if (e.name == name) return e.seconds;
  return 0;
}

void Stage_log::count_for_innermost()
{
  m_timer.stop();
  Entry& e = m_entries[m_open.back()];
  e.seconds += m_timer.time();
  e.peak_memory = peak_memory();
  m_timer.reset();
}

std::string Stage_log::report() const
{
  const double megabyte = 1e6;
  std::size_t width = 5;
  for (const Entry& e : m_entries) width = (std::max)(width, e.name.size());
  std::ostringstream os;
  os << std::fixed;
  const auto line = [&](const std::string& name, double seconds, std::size_t memory) {
    os << std::left << std::setw(int(width)) << name << std::right << std::setprecision(3) << std::setw(11) << seconds
       << " s";
    if (memory > 0) os << std::setprecision(0) << std::setw(9) << double(memory) / megabyte << " MB";
    os << '\n';
  };
  os << std::left << std::setw(int(width)) << "stage"
     << "         time"
     << "  peak so far\n";
  for (const Entry& e : m_entries) line(e.name, e.seconds, e.peak_memory);
  line("total", total_seconds(), peak_memory());
  return os.str();
}

} // namespace Programs
