// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "options/write_manual_page.h"

#include "options/Option_groups.h"

#include <algorithm>
#include <cctype>
#include <ostream>

namespace Programs {

namespace {

// Text as roff takes it: a backslash begins an escape, a hyphen must not become a typographic one, since options are copied
// from the page, and a full stop or an apostrophe at the beginning of a line would be a request.
std::string roff(const std::string& text)
{
  std::string s;
  for (char c : text) {
    if ((c == '.' || c == '\'') && (s.empty() || s.back() == '\n')) s += "\\&";
    if (c == '\\')
      s += "\\e";
    else if (c == '-')
      s += "\\-";
    else
      s += c;
  }
  return s;
}

std::string upper_case(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::toupper(c)); });
  return text;
}

} // namespace

void write_manual_page(std::ostream& os, const Manual_page& page, const Option_groups& options)
{
  os << ".TH " << upper_case(page.program) << " 1 \"\" \"Animated_mesh_features " << page.version << "\"\n"
     << ".SH NAME\n"
     << roff(page.program) << " \\- " << roff(page.summary) << "\n.SH SYNOPSIS\n.B " << roff(page.program) << '\n'
     << roff(page.usage) << "\n.SH OPTIONS\n";
  std::string group;
  for (const Option_description& o : options.described()) {
    if (o.group != group) os << ".SS " << roff(o.group) << '\n';
    group = o.group;
    os << ".TP\n\\fB";
    if (!o.short_name.empty()) os << "\\-" << roff(o.short_name) << "\\fR, \\fB";
    os << "\\-\\-" << roff(o.name) << "\\fR";
    if (!o.value_name.empty()) os << " \\fI" << roff(o.value_name) << "\\fR";
    os << '\n' << roff(o.text) << '\n';
  }
  for (const auto& section : page.sections)
    os << ".SH " << roff(upper_case(section.first)) << "\n.nf\n" << roff(section.second) << "\n.fi\n";
}

} // namespace Programs
