// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_TEST_IO_SUPPORT_H
#define CGAL_ANIMATED_MESH_FEATURES_TEST_IO_SUPPORT_H

#include "test_support.h"

#include <clocale>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <random>
#include <string>

namespace test_support {

// A new folder for the files of a test; removed with all that is in it.
class Temporary_folder
{
public:
  Temporary_folder()
  {
    std::random_device random;
    do {
      m_path = std::filesystem::temp_directory_path() / ("test_io_" + std::to_string(random()));
    } while (!std::filesystem::create_directory(m_path));
  }

  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  ~Temporary_folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }

  std::string path() const { return m_path.string(); }
  std::string path(const std::string& name) const { return (m_path / name).string(); }

  std::string write(const std::string& name, const std::string& content) const
  {
    std::filesystem::create_directories((m_path / name).parent_path());
    std::ofstream file(m_path / name, std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    if (!file) throw std::runtime_error("cannot write " + path(name));
    return path(name);
  }

  std::string read(const std::string& name) const
  {
    std::ifstream file(m_path / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }

  // files, folders and links, hidden ones too
  std::size_t number_of_entries() const
  {
    return std::size_t(
        std::distance(std::filesystem::directory_iterator(m_path), std::filesystem::directory_iterator()));
  }

private:
  std::filesystem::path m_path;
};

// Decimal commas and thousands points for all streams from now on, and for the C library where such a locale is
// installed. Whatever depends on the locale fails under it.
inline void use_hostile_locale()
{
  struct Punctuation : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  std::locale::global(std::locale(std::locale::classic(), new Punctuation));
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE"})
    if (std::setlocale(LC_ALL, name) != nullptr) break;
}

// The bytes of 32-bit scalars, made without the code under test.
inline std::string little_endian(std::uint32_t u)
{
  return {char(u & 255), char((u >> 8) & 255), char((u >> 16) & 255), char(u >> 24)};
}

inline std::string little_endian(float x)
{
  std::uint32_t u;
  std::memcpy(&u, &x, 4);
  return little_endian(u);
}

template <class T>
std::string big_endian(T x)
{
  const std::string bytes = little_endian(x);
  return std::string(bytes.rbegin(), bytes.rend());
}

} // namespace test_support

#endif // CGAL_ANIMATED_MESH_FEATURES_TEST_IO_SUPPORT_H
