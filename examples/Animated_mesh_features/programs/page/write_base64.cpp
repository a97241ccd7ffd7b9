// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/write_base64.h"

#include <cstddef>

namespace Programs {

void write_base64(std::ostream& os, const std::string& bytes)
{
  const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t i) {
    return i < bytes.size() ? unsigned(static_cast<unsigned char>(bytes[i])) : 0u;
  };
  const std::size_t large = 1 << 16;
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const unsigned group = (byte(i) << 16) | (byte(i + 1) << 8) | byte(i + 2);
    const std::size_t given = bytes.size() - i;
    text += digits[group >> 18];
    text += digits[(group >> 12) & 63];
    text += given > 1 ? digits[(group >> 6) & 63] : '=';
    text += given > 2 ? digits[group & 63] : '=';
    if (text.size() >= large) {
      os.write(text.data(), static_cast<std::streamsize>(text.size()));
      text.clear();
    }
  }
  os.write(text.data(), static_cast<std::streamsize>(text.size()));
}

} // namespace Programs
