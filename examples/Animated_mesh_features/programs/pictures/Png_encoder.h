// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PICTURES_PNG_ENCODER_H
#define PROGRAMS_PICTURES_PNG_ENCODER_H

#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>
#include "page/deflate.h"
#include "rendering/Image.h"

#include <zlib.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Portable Network Graphics (W3C recommendation, second edition): 8 bits a channel, RGB, no interlace.

typedef std::array<std::uint8_t, 3> Png_pixel;

inline void append_png_chunk(std::string& png, std::string_view type, std::string_view data)
{
  const auto append_number = [&png](std::uint32_t x) {
    char bytes[4];
    store(bytes, x, Byte_order::BIG_ENDIAN_ORDER);
    png.append(bytes, sizeof bytes);
  };
  append_number(std::uint32_t(data.size()));
  const std::size_t begin = png.size();
  png += type;
  png += data;
  const uLong sum = crc32(0, reinterpret_cast<const Bytef*>(png.data() + begin), uInt(png.size() - begin));
  append_number(std::uint32_t(sum));
}

// The rows, each behind the number of the filter that makes it look smallest: the one with the least sum of absolute
// differences, as the recommendation suggests.
inline std::string filtered_png_rows(const Animated_mesh_features::Rendering::Image_of<Png_pixel>& image)
{
  const std::size_t pixel = 3, length = pixel * image.width();
  const auto paeth = [](int left, int above, int corner) {
    const int p = left + above - corner;
    const int a = std::abs(p - left), b = std::abs(p - above), c = std::abs(p - corner);
    return a <= b && a <= c ? left : b <= c ? above : corner;
  };
  std::string result;
  result.reserve(image.height() * (length + 1));
  for (std::size_t y = 0; y < image.height(); ++y) {
    const auto byte = [&](std::size_t i, bool is_above) -> int {
      return is_above && y == 0 ? 0 : image(i / pixel, is_above ? y - 1 : y)[i % pixel];
    };
    std::string best;
    long least = -1;
    for (int filter = 0; filter < 5; ++filter) {
      std::string row(1, char(filter));
      long sum = 0;
      for (std::size_t i = 0; i < length; ++i) {
        const int left = i < pixel ? 0 : byte(i - pixel, false), above = byte(i, true);
        const int corner = i < pixel ? 0 : byte(i - pixel, true);
        const int prediction[] = {0, left, above, (left + above) / 2, paeth(left, above, corner)};
        const std::uint8_t difference = std::uint8_t(byte(i, false) - prediction[filter]);
        row.push_back(char(difference));
        sum += difference < 128 ? difference : 256 - difference;
      }
      if (least < 0 || sum < least) {
        least = sum;
        best.swap(row);
      }
    }
    result += best;
  }
  return result;
}

inline std::string encoded_png(const Animated_mesh_features::Rendering::Image_of<Png_pixel>& image)
{
  std::string png("\x89PNG\r\n\x1a\n", 8);
  char header[13] = {};
  store(header, std::uint32_t(image.width()), Byte_order::BIG_ENDIAN_ORDER);
  store(header + 4, std::uint32_t(image.height()), Byte_order::BIG_ENDIAN_ORDER);
  header[8] = 8; // bits
  header[9] = 2; // RGB
  append_png_chunk(png, "IHDR", std::string_view(header, sizeof header));
  append_png_chunk(png, "sRGB", std::string_view("\0", 1)); // perceptual
  append_png_chunk(png, "IDAT", deflated(filtered_png_rows(image)));
  append_png_chunk(png, "IEND", "");
  return png;
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_PICTURES_PNG_ENCODER_H
