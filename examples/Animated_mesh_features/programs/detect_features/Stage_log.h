// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_STAGE_LOG_H
#define DETECT_FEATURES_STAGE_LOG_H

#include <CGAL/Real_timer.h>

#ifndef _WIN32
  #include <sys/resource.h>
#endif

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace Detect_features {

// The largest memory that the program has had so far (bytes); 0 if it is not known.
inline std::size_t peak_memory()
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

// The time of each stage, and the peak of memory at its end. A stage that runs in several portions is one entry.
class Stage_log
{
public:
  struct Entry
  {
    std::string name;
    double seconds;
    std::size_t peak_memory;
  };

  Stage_log() { m_total.start(); }

  void begin(const std::string& name)
  {
    m_current =
        std::size_t(std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& e) { return e.name == name; }) -
                    m_entries.begin());
    if (m_current == m_entries.size()) m_entries.push_back({name, 0, 0});
    m_timer.reset();
    m_timer.start();
  }

  void end()
  {
    m_timer.stop();
    m_entries[m_current].seconds += m_timer.time();
    m_entries[m_current].peak_memory = peak_memory();
  }

  const std::vector<Entry>& entries() const { return m_entries; }
  double total_seconds() const { return m_total.time(); }

  // begin() and end() around a scope.
  class Scope
  {
  public:
    Scope(Stage_log& log, const std::string& name)
      : m_log(log)
    {
      m_log.begin(name);
    }
    ~Scope() { m_log.end(); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    Stage_log& m_log;
  };

private:
  std::vector<Entry> m_entries;
  std::size_t m_current = 0;
  CGAL::Real_timer m_timer, m_total;
};

} // namespace Detect_features

#endif // DETECT_FEATURES_STAGE_LOG_H
