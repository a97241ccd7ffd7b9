// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "options/Option_groups.h"

#include "options/suggestion.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <ostream>
#include <utility>

namespace po = boost::program_options;
using CGAL::Animated_mesh_features::Option_error;

namespace Programs {

namespace {

// of the help text
const unsigned line_length = 100, description_length = 64;

std::string long_name(const std::string& name)
{
  return name.substr(0, name.find(','));
}

void check_not_empty(const po::variables_map& given)
{
  for (const auto& g : given) {
    const std::string* const value = boost::any_cast<std::string>(&g.second.value());
    if (value != nullptr && value->empty()) throw Option_error("--" + g.first + ": the value is empty");
  }
}

} // namespace

Option_group::Option_group(const std::string& title)
  : m_title(title)
  , m_description(title, line_length, description_length)
{}

void Option_group::add(const std::string& name, const std::string& value_name, const std::string& description, Use use)
{
  m_description.add_options()(name.c_str(), po::value<std::string>()->value_name(value_name), description.c_str());
  m_options.push_back({long_name(name), std::move(use)});
}

void Option_group::add_repeatable(const std::string& name, const std::string& value_name,
                                  const std::string& description, Use use)
{
  m_description.add_options()(name.c_str(), po::value<std::vector<std::string>>()->value_name(value_name)->composing(),
                              description.c_str());
  m_options.push_back({long_name(name), std::move(use)});
}

void Option_group::add_switch(const std::string& name, bool& is_given, const std::string& description)
{
  m_description.add_options()(name.c_str(), po::bool_switch(&is_given), description.c_str());
}

Option_group& Option_groups::add_group(const std::string& title)
{
  return m_groups.emplace_back(title);
}

void Option_groups::add_positional(const std::string& name, std::vector<std::string>& to, int most)
{
  m_hidden.add_options()(name.c_str(), po::value(&to));
  m_positional.add(name.c_str(), most);
}

po::options_description Option_groups::descriptions() const
{
  po::options_description all;
  for (const Option_group& group : m_groups) all.add(group.m_description);
  return all;
}

void Option_groups::parse(int argc, const char* const* argv)
{
  po::options_description options = descriptions();
  options.add(m_hidden);
  using namespace po::command_line_style;
  try {
    po::store(po::command_line_parser(argc, argv)
                  .options(options)
                  .positional(m_positional)
                  .style(unix_style & ~allow_guessing)
                  .run(),
              m_given);
    po::notify(m_given);
  } catch (const po::unknown_option& e) {
    std::vector<std::string> known;
    for (const Option_description& option : described()) known.push_back("--" + option.name);
    // what is no name begins with one dash, or with two
    const std::string typed = e.get_option_name(), name = typed.substr((std::min)(typed.find_first_not_of('-'), typed.size()));
    throw Option_error("there is no option " + typed + suggestion("--" + name, known));
  } catch (const po::error& e) {
    throw Option_error(e.what());
  }
  check_not_empty(m_given);
}

void Option_groups::use() const
{
  for (const Option_group& group : m_groups)
    for (const Option_group::Option& option : group.m_options) {
      const po::variable_value& value = m_given[option.name];
      if (const auto* const text = boost::any_cast<std::string>(&value.value()))
        option.use(Argument("--" + option.name, *text));
      else if (const auto* const texts = boost::any_cast<std::vector<std::string>>(&value.value()))
        for (const std::string& t : *texts) option.use(Argument("--" + option.name, t));
    }
}

std::vector<Option_description> Option_groups::described() const
{
  std::vector<Option_description> all;
  for (const Option_group& group : m_groups)
    for (const auto& option : group.m_description.options()) {
      const std::string short_name = option->canonical_display_name(po::command_line_style::allow_dash_for_short);
      const bool has_value = option->semantic()->max_tokens() > 0;
      all.push_back({group.m_title, option->long_name(), short_name.size() == 2 ? short_name.substr(1) : "",
                     has_value ? option->semantic()->name() : "", option->description()});
    }
  return all;
}

std::ostream& operator<<(std::ostream& os, const Option_groups& groups)
{
  return os << groups.descriptions();
}

} // namespace Programs
