// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_TEXT_OUTPUT_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_TEXT_OUTPUT_H

#include <CGAL/Animated_mesh_features/IO/internal/numbers.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Text for a stream, in large pieces and whatever the stream's locale. To be ended by `flush()`: a destructor could not
// let an exception of the stream pass.
class Text_output
{
public:
  explicit Text_output(std::ostream& os)
    : m_os(os)
  {}

  Text_output& operator<<(std::string_view text)
  {
    m_text += text;
    const std::size_t large = 1 << 16;
    if (m_text.size() >= large) flush();
    return *this;
  }

  Text_output& operator<<(const char* text) { return *this << std::string_view(text); }
  Text_output& operator<<(char c) { return *this << std::string_view(&c, 1); }
  Text_output& operator<<(bool b) { return *this << (b ? "true" : "false"); }

  template <class Number>
  std::enable_if_t<std::is_arithmetic<Number>::value, Text_output&> operator<<(Number x)
  {
    append_number(m_text, x);
    return *this;
  }

  void flush()
  {
    m_os.write(m_text.data(), static_cast<std::streamsize>(m_text.size()));
    m_text.clear();
  }

private:
  std::ostream& m_os;
  std::string m_text;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_TEXT_OUTPUT_H
