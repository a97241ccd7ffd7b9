// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OPTIONS_OPTION_GROUPS_H
#define PROGRAMS_OPTIONS_OPTION_GROUPS_H

#include "options/Argument.h"

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/positional_options.hpp>
#include <boost/program_options/variables_map.hpp>

#include <functional>
#include <iosfwd>
#include <list>
#include <string>
#include <vector>

namespace Programs {

// An option, as texts about the program tell it.
struct Option_description
{
  std::string group; // its title
  std::string name;
  std::string short_name; // a letter; empty if there is none
  std::string value_name; // empty if it has no value
  std::string text;
};

// Options under one title of the help text. Each part of the programs adds its own, together with what becomes of them.
class Option_group
{
public:
  typedef std::function<void(const Argument&)> Use;

  explicit Option_group(const std::string& title);

  // An option with a value. `name` may end with a comma and a short name; `value_name` is what the help text calls the
  // value.
  void add(const std::string& name, const std::string& value_name, const std::string& description, Use use);

  // The same, which may be given several times; it is used once for each of them.
  void add_repeatable(const std::string& name, const std::string& value_name, const std::string& description, Use use);

  // `is_given` tells whether an option without a value is given.
  void add_switch(const std::string& name, bool& is_given, const std::string& description);

private:
  friend class Option_groups;

  struct Option
  {
    std::string name;
    Use use;
  };

  std::string m_title;
  boost::program_options::options_description m_description;
  std::vector<Option> m_options; // that have a value
};

// The command line of a program: groups of options, and what is not an option.
//
// Arguments are used in the order in which the options were added, whatever order they are typed in: an option may rely on
// those that were added before it.
class Option_groups
{
public:
  // to which options are to be added; stays where it is.
  Option_group& add_group(const std::string& title);

  // `to` takes what is no option, `most` such arguments or, if it is negative, any number of them.
  void add_positional(const std::string& name, std::vector<std::string>& to, int most);

  // Understands the structure of the command line, sets the switches and what is no option. Names of options cannot be
  // abbreviated: an option that comes later must not change what a script means.
  // throws Option_error.
  void parse(int argc, const char* const* argv);

  // Uses the arguments that were parsed.
  // throws what their uses throw.
  void use() const;

  // All options, in the order of the help text.
  std::vector<Option_description> described() const;

  // The options, for the help text.
  friend std::ostream& operator<<(std::ostream& os, const Option_groups& groups);

private:
  boost::program_options::options_description descriptions() const;

  std::list<Option_group> m_groups;
  boost::program_options::options_description m_hidden;
  boost::program_options::positional_options_description m_positional;
  boost::program_options::variables_map m_given;
};

} // namespace Programs

#endif // PROGRAMS_OPTIONS_OPTION_GROUPS_H
