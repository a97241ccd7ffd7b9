// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "options/write_completion.h"

#include "options/Option_groups.h"

#include <ostream>

namespace Programs {

namespace {

// Up to the first colon or full stop, or "(default": enough for a list.
std::string summary(const std::string& text)
{
  std::string s = text.substr(0, text.find(" (default"));
  for (const char* end : {": ", "; ", ". "}) s = s.substr(0, s.find(end));
  return s;
}

// `text` with a backslash before each of some letters
std::string escaped(const std::string& text, const std::string& letters)
{
  std::string s;
  for (char c : text) {
    if (letters.find(c) != std::string::npos) s += '\\';
    s += c;
  }
  return s;
}

// Within apostrophes, where an apostrophe itself has to end them for a moment.
std::string quoted(const std::string& text)
{
  std::string s = "'";
  for (char c : text) {
    if (c == '\'')
      s += "'\\''";
    else
      s += c;
  }
  return s + "'";
}

// The value of an option may be a file unless its name says otherwise, and so may what is no option.
void write_bash(std::ostream& os, const std::string& program, const std::vector<Option_description>& options)
{
  os << "# bash completion of " << program << "\n_" << program << "()\n{\n"
     << "  COMPREPLY=()\n"
     << "  if [[ \"${COMP_WORDS[COMP_CWORD]}\" == -* ]]; then\n"
     << "    COMPREPLY=($(compgen -W '";
  const char* separator = "";
  for (const Option_description& o : options) {
    os << separator << "--" << o.name;
    separator = " ";
  }
  os << "' -- \"${COMP_WORDS[COMP_CWORD]}\"))\n  fi\n}\n"
     << "complete -o default -F _" << program << ' ' << program << '\n';
}

void write_zsh(std::ostream& os, const std::string& program, const std::vector<Option_description>& options)
{
  os << "#compdef " << program << "\n_arguments \\\n";
  for (const Option_description& o : options) {
    const std::string text = "[" + escaped(summary(o.text), "[]:\\") + "]";
    const std::string value = o.value_name.empty() ? "" : ":" + escaped(o.value_name, ":\\") + ":_files";
    if (!o.short_name.empty()) os << "  " << quoted("*-" + o.short_name + text + value) << " \\\n";
    os << "  " << quoted("*--" + o.name + text + value) << " \\\n";
  }
  os << "  '*:input:_files'\n";
}

void write_fish(std::ostream& os, const std::string& program, const std::vector<Option_description>& options)
{
  os << "# fish completion of " << program << '\n';
  for (const Option_description& o : options) {
    os << "complete -c " << program << " -l " << o.name;
    if (!o.short_name.empty()) os << " -s " << o.short_name;
    if (!o.value_name.empty()) os << " -r";
    std::string text = "'"; // where fish has escapes
    text += escaped(summary(o.text), "'\\") + "'";
    os << " -d " << text << '\n';
  }
}

} // namespace

Names<Shell> names(Shell)
{
  return {{"bash", Shell::BASH}, {"zsh", Shell::ZSH}, {"fish", Shell::FISH}};
}

void write_completion(std::ostream& os, Shell shell, const std::string& program, const Option_groups& options)
{
  switch (shell) {
  case Shell::BASH: return write_bash(os, program, options.described());
  case Shell::ZSH: return write_zsh(os, program, options.described());
  case Shell::FISH: return write_fish(os, program, options.described());
  }
}

} // namespace Programs
