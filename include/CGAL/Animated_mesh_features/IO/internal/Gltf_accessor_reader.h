// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_ACCESSOR_READER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_ACCESSOR_READER_H

#include <CGAL/Animated_mesh_features/IO/internal/Gltf_check.h>
#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>
#include <CGAL/Animated_mesh_features/IO/internal/numbers.h>

#include <tiny_gltf.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Reads arrays of numbers from the buffers of a glTF file: of any type of component, strided, normalised, sparse.
// Nothing is read outside of a buffer, and no memory is taken that the bytes of the buffers do not account for, whatever
// the file says: an array that is sparse, or that many refer to, costs a few bytes of the file and may have any size.
class Gltf_accessor_reader
{
public:
  Gltf_accessor_reader(const tinygltf::Model& model, const Gltf_check& check)
    : m_model(model)
    , m_check(check)
  {
    for (const tinygltf::Buffer& buffer : model.buffers) m_bytes += buffer.data.size();
    // Rigs of faces have some 15 numbers for each byte: a sparse morph target has a number for each coordinate.
    const std::size_t numbers_per_byte = 64, numbers_of_any_file = std::size_t(1) << 23;
    m_numbers_left = numbers_of_any_file + numbers_per_byte * m_bytes;
  }

  // To be called for what takes memory for `numbers` numbers each time that something refers to it.
  void account(std::size_t numbers, const std::string& name) const
  {
    if (numbers > m_numbers_left)
      m_check.fail(name + ": the file takes more memory than its " + std::to_string(m_bytes) +
                   " bytes of data account for");
    m_numbers_left -= numbers;
  }

  // The elements of an accessor one after the other, `width` numbers each. `use` says what for, for messages.
  std::vector<double> read(int index, std::size_t width, const std::string& use) const
  {
    const tinygltf::Accessor& a = accessor(index, use);
    const std::string name = use + ": accessor " + std::to_string(index);
    if (components(a.type) != width)
      m_check.fail(name + " has " + std::to_string(components(a.type)) + " numbers in an element, not " +
                   std::to_string(width));
    const Place place{a.bufferView, a.byteOffset, a.componentType, a.normalized};
    if (a.bufferView >= 0)
      first_byte(place, a.count, width, name); // that it is there
    else if (!a.sparse.isSparse)
      m_check.fail(name + " has no data; it may be compressed in a way that is not supported");
    else if (a.count > m_bytes)
      m_check.fail(name + " has more elements than the file has bytes");
    account(a.count * width, name);
    std::vector<double> values(a.count * width, 0);
    if (a.bufferView >= 0) read_elements(place, a.count, width, name, values.data());
    if (a.sparse.isSparse) replace_sparse(a, width, name, values);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!is_finite(values[i])) m_check.fail(name + ": element " + std::to_string(i / width) + " is not finite");
    return values;
  }

  // Whole numbers, for indices.
  std::vector<std::size_t> read_indices(int index, std::size_t width, const std::string& use) const
  {
    const int type = accessor(index, use).componentType;
    if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
        type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
      m_check.fail(use + ": accessor " + std::to_string(index) + " does not hold whole numbers");
    const std::vector<double> values = read(index, width, use);
    std::vector<std::size_t> indices(values.size());
    std::transform(values.begin(), values.end(), indices.begin(), [](double x) { return std::size_t(x); });
    return indices;
  }

private:
  struct Place
  {
    int view;
    std::size_t offset;
    int component_type;
    bool is_normalized;
  };

  const tinygltf::Accessor& accessor(int index, const std::string& use) const
  {
    if (index < 0 || std::size_t(index) >= m_model.accessors.size())
      m_check.fail(use + ": there is no accessor " + std::to_string(index));
    return m_model.accessors[std::size_t(index)];
  }

  static std::size_t components(int type)
  {
    const int n = tinygltf::GetNumComponentsInType(std::uint32_t(type));
    return n > 0 ? std::size_t(n) : 0;
  }

  static std::size_t component_size(const Place& place)
  {
    const int size = tinygltf::GetComponentSizeInBytes(std::uint32_t(place.component_type));
    return size > 0 ? std::size_t(size) : 0;
  }

  // of a view that is there
  std::size_t byte_stride(const Place& place, std::size_t width) const
  {
    const std::size_t stride = m_model.bufferViews[std::size_t(place.view)].byteStride;
    return stride == 0 ? width * component_size(place) : stride;
  }

  // Where the elements begin; all of them are inside of their buffer.
  const char* first_byte(const Place& place, std::size_t count, std::size_t width, const std::string& name) const
  {
    const std::size_t element = width * component_size(place);
    if (element == 0) m_check.fail(name + " has components of an unknown type " + std::to_string(place.component_type));
    if (place.view < 0 || std::size_t(place.view) >= m_model.bufferViews.size())
      m_check.fail(name + ": there is no buffer view " + std::to_string(place.view));
    const tinygltf::BufferView& view = m_model.bufferViews[std::size_t(place.view)];
    if (view.buffer < 0 || std::size_t(view.buffer) >= m_model.buffers.size())
      m_check.fail(name + ": there is no buffer " + std::to_string(view.buffer));
    const std::vector<unsigned char>& data = m_model.buffers[std::size_t(view.buffer)].data;
    const bool is_inside =
        view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset &&
        place.offset <= view.byteLength &&
        (count == 0 || (element <= view.byteLength - place.offset &&
                        (count - 1) <= (view.byteLength - place.offset - element) / byte_stride(place, width)));
    if (!is_inside) m_check.fail(name + " exceeds its buffer");
    return reinterpret_cast<const char*>(data.data()) + view.byteOffset + place.offset;
  }

  void read_elements(const Place& place, std::size_t count, std::size_t width, const std::string& name,
                     double* values) const
  {
    switch (place.component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return read_as<std::int8_t>(place, count, width, name, values);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return read_as<std::uint8_t>(place, count, width, name, values);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return read_as<std::int16_t>(place, count, width, name, values);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return read_as<std::uint16_t>(place, count, width, name, values);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return read_as<std::uint32_t>(place, count, width, name, values);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return read_as<float>(place, count, width, name, values);
    default:
      m_check.fail(name + " has components of an unknown type " + std::to_string(place.component_type));
    }
  }

  template <class Component>
  void read_as(const Place& place, std::size_t count, std::size_t width, const std::string& name, double* values) const
  {
    if (count == 0) return;
    const char* bytes = first_byte(place, count, width, name);
    const std::size_t stride = byte_stride(place, width);
    for (std::size_t i = 0; i < count; ++i, bytes += stride)
      for (std::size_t k = 0; k < width; ++k) {
        const Component c = load<Component>(bytes + k * sizeof(Component), Byte_order::LITTLE_ENDIAN_ORDER);
        *values++ = place.is_normalized ? normalized(c) : double(c);
      }
  }

  // Fractions of the largest number of the type, as the specification has it: signed ones are symmetric.
  template <class Component>
  static double normalized(Component c)
  {
    if constexpr (std::is_integral<Component>::value)
      return (std::max)(double(c) / double((std::numeric_limits<Component>::max)()), -1.);
    else
      return double(c);
  }

  void replace_sparse(const tinygltf::Accessor& a, std::size_t width, const std::string& name,
                      std::vector<double>& values) const
  {
    const std::string sparse = name + ", sparse part";
    if (a.sparse.count < 0 || std::size_t(a.sparse.count) > a.count || a.sparse.indices.byteOffset < 0 ||
        a.sparse.values.byteOffset < 0)
      m_check.fail(sparse + " has a size or place that makes no sense");
    const std::size_t n = std::size_t(a.sparse.count);
    const Place at_indices{a.sparse.indices.bufferView, std::size_t(a.sparse.indices.byteOffset),
                           a.sparse.indices.componentType, false};
    const Place at_values{a.sparse.values.bufferView, std::size_t(a.sparse.values.byteOffset), a.componentType,
                          a.normalized};
    first_byte(at_indices, n, 1, sparse);
    first_byte(at_values, n, width, sparse);
    std::vector<double> indices(n), replacements(n * width);
    read_elements(at_indices, n, 1, sparse, indices.data());
    read_elements(at_values, n, width, sparse, replacements.data());
    for (std::size_t i = 0; i < n; ++i) {
      if (!(indices[i] >= 0 && indices[i] < double(a.count)))
        m_check.fail(sparse + " replaces an element that is not there");
      std::copy(&replacements[i * width], &replacements[i * width] + width, &values[std::size_t(indices[i]) * width]);
    }
  }

  const tinygltf::Model& m_model;
  const Gltf_check& m_check;
  std::size_t m_bytes = 0;            // of all buffers
  mutable std::size_t m_numbers_left; // that may still be read
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_ACCESSOR_READER_H
