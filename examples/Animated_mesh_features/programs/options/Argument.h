// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OPTIONS_ARGUMENT_H
#define PROGRAMS_OPTIONS_ARGUMENT_H

#include "options/Names.h"

#include <cstddef>
#include <string>
#include <utility>

namespace Programs {

// What was typed for an option, to be understood in one way or another. What cannot be understood is an Option_error that
// names the option and shows the text.
class Argument
{
public:
  // `option` as messages name it: with its dashes.
  Argument(std::string option, std::string text)
    : m_option(std::move(option))
    , m_text(std::move(text))
  {}

  const std::string& option() const { return m_option; }
  const std::string& text() const { return m_text; }

  // a part of the text, for the same option
  Argument part(std::size_t begin, std::size_t length = std::string::npos) const
  {
    return Argument(m_option, m_text.substr(begin, length));
  }

  double number() const; // finite
  double positive_number() const;
  double non_negative_number() const;
  std::size_t count() const; // of up to nine digits, so that it fits into whatever counts
  std::size_t bytes() const; // a number followed by K, M, G or T (of 1024), or by none of them

  template <class Choice>
  Choice choice() const
  {
    return chosen<Choice>(m_option, m_text);
  }

  // throws Option_error: the option, the text, and what is wrong with it: "is no number", for instance
  [[noreturn]] void refuse(const std::string& reason) const;

private:
  std::string m_option, m_text;
};

} // namespace Programs

#endif // PROGRAMS_OPTIONS_ARGUMENT_H
