// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OUTPUT_WANTED_FIELDS_H
#define PROGRAMS_OUTPUT_WANTED_FIELDS_H

#include "output/Output_options.h"
#include "output/Result_files.h"
#include "reading/Values.h"
#include "running/Stage_log.h"

#include <list>
#include <utility>

namespace Programs {

// The fields that go to files as soon as they are known, and those that are kept because scenes show them. Whoever
// computes fields hands them to this and needs not know what they are for.
class Wanted_fields
{
public:
  struct Kept_field
  {
    Field kind;
    Values values;
  };

  // Keeps references to all three.
  Wanted_fields(const Output_options& options, Result_files& files, Stage_log& log)
    : m_options(options)
    , m_files(files)
    , m_log(log)
  {}

  virtual ~Wanted_fields() = default;
  Wanted_fields(const Wanted_fields&) = delete;
  Wanted_fields& operator=(const Wanted_fields&) = delete;

  bool is_written(Field kind) const { return m_options.is_written(kind); }

  // whether the result of the detection has it; who wants it for other reasons than scenes says so here.
  virtual bool is_kept(Field kind) const { return m_options.is_shown(kind); }
  bool is_wanted(Field kind) const { return is_written(kind) || is_kept(kind); }

  // Writes the field if a file wants it.
  // throws Output_error.
  void write(Field kind, const Values& field)
  {
    if (!is_written(kind)) return;
    const Stage_log::Scope stage(m_log, "writing");
    m_files.write_field(kind, field);
  }

  // To be called for fields of which is_kept() tells so.
  void keep(Field kind, Values field)
  {
    m_kept.insert(kind == Field::DEFORMATION ? m_kept.begin() : m_kept.end(), {kind, std::move(field)});
  }

  // The deformation first: it is what features are features of.
  const std::list<Kept_field>& kept() const { return m_kept; }

  // The same, handed over.
  std::list<Kept_field> take_kept() { return std::move(m_kept); }

private:
  const Output_options& m_options;
  Result_files& m_files;
  Stage_log& m_log;
  std::list<Kept_field> m_kept; // a list, since fields are large: none of them is moved
};

} // namespace Programs

#endif // PROGRAMS_OUTPUT_WANTED_FIELDS_H
