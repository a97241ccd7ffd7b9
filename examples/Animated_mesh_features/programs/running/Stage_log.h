// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RUNNING_STAGE_LOG_H
#define PROGRAMS_RUNNING_STAGE_LOG_H

#include <CGAL/Real_timer.h>

#include <cstddef>
#include <string>
#include <vector>

namespace Programs {

// The time of each stage, and the peak of memory at its end. A stage that runs in several portions is one entry; one that
// runs within another is an entry of its own, and its time is not the other's.
class Stage_log
{
public:
  struct Entry
  {
    std::string name;
    double seconds;
    std::size_t peak_memory; // bytes; 0 if it is not known
  };

  Stage_log() { m_total.start(); }

  void begin(const std::string& name);
  void end();

  const std::vector<Entry>& entries() const { return m_entries; }
  double total_seconds() const { return m_total.time(); }

  // of a stage; 0 if there was none of that name
  double seconds(const std::string& name) const;

  // a table, for --verbose
  std::string report() const;

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
  void count_for_innermost();

  std::vector<Entry> m_entries;
  std::vector<std::size_t> m_open; // entries, the innermost last
  CGAL::Real_timer m_timer, m_total;
};

} // namespace Programs

#endif // PROGRAMS_RUNNING_STAGE_LOG_H
