// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_TEXT_SCANNER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_TEXT_SCANNER_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/internal/numbers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Letters of ASCII; `keyword` is in small ones.
inline bool equal_but_for_case(std::string_view word, std::string_view keyword)
{
  const auto equal = [](char c, char k) { return c == k || (c >= 'A' && c <= 'Z' && c - 'A' + 'a' == k); };
  return word.size() == keyword.size() && std::equal(word.begin(), word.end(), keyword.begin(), equal);
}

// Reads a text that is in memory, line by line and token by token, and knows the line for messages. Carriage returns
// are blanks, so that line ends of any system do.
class Text_scanner
{
public:
  // `comment`: from this character to the end of the line is nothing; '\0' if there are no comments.
  // `continued_lines`: a backslash before the end of a line is a blank, as that end is.
  Text_scanner(const std::string& text, const std::string& file, char comment, bool continued_lines = false)
    : m_begin(text.data())
    , m_p(m_begin)
    , m_end(m_begin + text.size())
    , m_file(file)
    , m_comment(comment)
    , m_continued_lines(continued_lines)
    , m_kinds()
  {
    for (char c : {' ', '\t', '\r', '\v', '\f'}) kind(c) = BLANK | DELIMITER;
    kind('\n') = LINE_END | DELIMITER;
    if (comment != '\0') kind(comment) = LINE_END | DELIMITER;
    if (continued_lines) kind('\\') = DELIMITER;
    const char byte_order_mark[] = "\xef\xbb\xbf";
    if (text.compare(0, 3, byte_order_mark) == 0) m_p += 3;
  }

  bool at_end() const { return m_p == m_end; }
  std::size_t line() const { return m_line; }
  const std::string& file() const { return m_file; }

  // what is left, for the binary part of a file
  const char* position() const { return m_p; }
  const char* end() const { return m_end; }

  bool at_end_of_line()
  {
    skip_blanks();
    return m_p == m_end || (kind(*m_p) & LINE_END) != 0;
  }

  // Moves to the start of the next line.
  void next_line()
  {
    if (m_p != m_end && *m_p == '\n') { // all of the line was read; a continued one goes on after its end
      ++m_p;
      ++m_line;
      return;
    }
    bool comment = false;
    while (m_p != m_end) {
      comment = comment || (m_comment != '\0' && *m_p == m_comment);
      const char* newline = static_cast<const char*>(std::memchr(m_p, '\n', std::size_t(m_end - m_p)));
      if (newline == nullptr) {
        m_p = m_end;
        return;
      }
      const char* last = newline;
      if (last != m_p && last[-1] == '\r') --last;
      const bool continued = m_continued_lines && !comment && last != m_p && last[-1] == '\\';
      m_p = newline + 1;
      ++m_line;
      if (!continued) return;
    }
  }

  // Moves to the next token, on this line or a later one.
  void skip_space()
  {
    while (at_end_of_line() && m_p != m_end) next_line();
  }

  // The characters up to the next blank; empty at the end of the line.
  std::string_view token()
  {
    if (at_end_of_line()) return std::string_view();
    const char* begin = m_p;
    skip_token();
    return std::string_view(begin, std::size_t(m_p - begin));
  }

  // The same, but up to the first character that does not satisfy a predicate.
  template <class Predicate>
  std::string_view token_of(const Predicate& is_part)
  {
    if (at_end_of_line()) return std::string_view();
    const char* begin = m_p;
    while (!at_delimiter() && is_part(*m_p)) ++m_p;
    return std::string_view(begin, std::size_t(m_p - begin));
  }

  // Skips the next token if it is this word.
  bool accept(std::string_view word)
  {
    const char* const p = m_p;
    const std::size_t line = m_line;
    if (token() == word) return true;
    m_p = p;
    m_line = line;
    return false;
  }

  void skip_token()
  {
    while (m_p != m_end && (kind(*m_p) & DELIMITER) == 0) ++m_p;
  }

  double number(const char* what)
  {
    double x = 0;
    const char* begin = start_of_value(what);
    if (!parse_number(m_p, m_end, x) || !at_delimiter()) throw_not_a("number", begin);
    return x;
  }

  // An integer; after it may stand `separator` and more text, which is skipped ('\0': nothing may).
  long long integer(const char* what, char separator = '\0')
  {
    long long i = 0;
    const char* begin = start_of_value(what);
    if (!parse_integer(m_p, m_end, i)) throw_not_a("whole number", begin);
    if (separator != '\0' && m_p != m_end && *m_p == separator) skip_token();
    if (!at_delimiter()) throw_not_a("whole number", begin);
    return i;
  }

  [[noreturn]] void fail(const std::string& message) const
  {
    throw Input_error(m_file + ":" + std::to_string(m_line) + ": " + message);
  }

  // A piece of the file, fit for a message: short and printable.
  static std::string quoted(std::string_view text)
  {
    const std::size_t longest = 40;
    std::string s = "\"";
    for (char c : text.substr(0, longest)) s += (c < ' ' || c == 0x7f) ? '?' : c;
    return s + (text.size() > longest ? "...\"" : "\"");
  }

private:
  enum Kind : unsigned char
  {
    BLANK = 1,
    LINE_END = 2, // a comment is the end of its line
    DELIMITER = 4 // what ends a token
  };

  unsigned char& kind(char c) { return m_kinds[static_cast<unsigned char>(c)]; }
  unsigned char kind(char c) const { return m_kinds[static_cast<unsigned char>(c)]; }

  bool at_delimiter() const { return m_p == m_end || (kind(*m_p) & DELIMITER) != 0; }

  void skip_blanks()
  {
    while (m_p != m_end && (kind(*m_p) & BLANK) != 0) ++m_p;
    if (m_continued_lines && m_p != m_end && *m_p == '\\') skip_backslashes_and_blanks();
  }

  void skip_backslashes_and_blanks()
  {
    while (true) {
      while (m_p != m_end && (kind(*m_p) & BLANK) != 0) ++m_p;
      if (m_p == m_end || *m_p != '\\') return;
      const char* newline = m_p + 1;
      if (newline != m_end && *newline == '\r') ++newline;
      if (newline != m_end && *newline != '\n') {
        ++m_p; // a stray backslash
        continue;
      }
      if (newline != m_end) ++m_line;
      m_p = newline == m_end ? m_end : newline + 1;
    }
  }

  const char* start_of_value(const char* what)
  {
    if (at_end_of_line()) throw_no_value(what);
    return m_p;
  }

  [[noreturn]] void throw_no_value(const char* what) const
  {
    if (m_p == m_end) fail(std::string("the file ends where ") + what + " should follow");
    fail(std::string("the line ends where ") + what + " should follow");
  }

  [[noreturn]] void throw_not_a(const char* kind, const char* begin)
  {
    skip_token();
    fail(quoted(std::string_view(begin, std::size_t(m_p - begin))) + " is not a " + kind);
  }

  const char* m_begin;
  const char* m_p;
  const char* m_end;
  const std::string& m_file;
  std::size_t m_line = 1;
  char m_comment;
  bool m_continued_lines;
  std::array<unsigned char, 256> m_kinds; // of each character, bits of Kind
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_TEXT_SCANNER_H
