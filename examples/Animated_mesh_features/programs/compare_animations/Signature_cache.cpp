// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "compare_animations/Signature_cache.h"

#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
namespace fs = std::filesystem;

namespace Compare_animations {

typedef nlohmann::json Cbor; // the same values in bytes

namespace {

// of the file's layout and of what is computed: files of another one are not found
const int version = 3;

// Fowler, Noll and Vo's FNV-1a, 64 bits.
class Hash
{
public:
  void add(const char* bytes, std::size_t n)
  {
    for (std::size_t i = 0; i < n; ++i) m_value = (m_value ^ std::uint8_t(bytes[i])) * 1099511628211ull;
  }
  void add(const std::string& text)
  {
    add(text.c_str(), text.size() + 1); // with its end
  }
  std::string text() const
  {
    std::ostringstream os;
    os << std::hex << m_value;
    return os.str();
  }

private:
  std::uint64_t m_value = 14695981039346656037ull;
};

void add_file(const fs::path& path, Hash& hash)
{
  std::ifstream is(path, std::ios::binary);
  if (!is) throw AMF::Input_error(path.string() + ": cannot read");
  std::vector<char> block(1 << 20);
  while (is) {
    is.read(block.data(), std::streamsize(block.size()));
    hash.add(block.data(), std::size_t(is.gcount()));
  }
}

// A file, or all files of a folder. Of a model its folder may have buffers.
void add_path(const fs::path& path, Hash& hash)
{
  std::error_code ignored;
  std::vector<fs::path> files;
  const bool has_buffers = path.extension() == ".gltf";
  if (fs::is_directory(path, ignored) || has_buffers) {
    for (const auto& entry : fs::directory_iterator(has_buffers ? path.parent_path() / "." : path, ignored))
      if (entry.is_regular_file(ignored) && entry.path().extension() != ".signature") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
  } else {
    files.push_back(path);
  }
  for (const fs::path& file : files) {
    hash.add(file.filename().string());
    add_file(file, hash);
  }
}

template <class T>
std::string text_of(const std::optional<T>& x)
{
  std::ostringstream os;
  os.precision(17);
  if (x) os << *x;
  return os.str();
}

// Whatever changes what is computed.
void add_options(const Item& item, const Settings& s, Hash& hash)
{
  const Programs::Reading_options& r = item.reading;
  std::ostringstream os;
  os.precision(17);
  os << version << ' ' << ANIMATED_MESH_FEATURES_VERSION << '\n'
     << text_of(r.frames_per_second) << '\n'
     << r.as_given << r.triangulate << r.repair << int(r.weld) << r.skip_bad_frames << int(r.denoise)
     << r.there_and_back << r.is_cyclic << '\n'
     << r.clip << '\n'
     << r.part << '\n'
     << text_of(r.clip_frames) << ' ' << (r.frame_range ? r.frame_range->text : "") << '\n'
     << r.faces_dataset << '\n'
     << int(r.rest.kind) << ' ' << r.rest.frame << ' ' << r.rest.rescale << '\n'
     << text_of(s.method.threshold) << ' ' << text_of(s.method.relative_threshold) << ' ' << text_of(s.method.min_fit)
     << ' ' << text_of(s.method.top) << ' ' << s.method.no_suppression << '\n'
     << s.is_oriented << ' ' << s.activity.sample_duration << ' ' << s.activity.lags << ' ' << s.activity.lag_step
     << ' ' << s.activity.max_samples;
  hash.add(os.str());
}

Cbor cbor_of(const AMF::Feature_point& f)
{
  return {f.vertex_index, f.frame,         f.time,  f.refined_frame, f.triangle,      f.barycentric_coordinates,
          f.position,     f.rest_position, f.sigma, f.tau,           f.response,      f.amplitude,
          f.fit,          f.strength,      f.place, f.parent,        f.at_scale_limit};
}

AMF::Feature_point feature_of(const Cbor& j)
{
  AMF::Feature_point f;
  std::size_t i = 0;
  const auto get = [&](auto& x) { j.at(i++).get_to(x); };
  get(f.vertex_index);
  get(f.frame);
  get(f.time);
  get(f.refined_frame);
  get(f.triangle);
  get(f.barycentric_coordinates);
  get(f.position);
  get(f.rest_position);
  get(f.sigma);
  get(f.tau);
  get(f.response);
  get(f.amplitude);
  get(f.fit);
  get(f.strength);
  get(f.place);
  get(f.parent);
  get(f.at_scale_limit);
  return f;
}

Cbor cbor_of(const AMF::Feature_descriptors& d)
{
  return {{"size", d.size()},
          {"length", d.length()},
          {"values",
           std::vector<float>(d.size() == 0 ? nullptr : d[0], d.size() == 0 ? nullptr : d[0] + d.size() * d.length())}};
}

AMF::Feature_descriptors descriptors_of(const Cbor& j)
{
  AMF::Feature_descriptors d(j.at("size"), j.at("length"));
  const std::vector<float> values = j.at("values");
  if (values.size() != d.size() * d.length()) throw AMF::Input_error("sizes do not fit");
  if (!values.empty()) std::copy(values.begin(), values.end(), d[0]);
  return d;
}

Cbor cbor_of(const AMF::Animation_signature& s)
{
  Cbor features = Cbor::array();
  for (const AMF::Feature_point& f : s.events.features) features.push_back(cbor_of(f));
  const AMF::Activity& a = s.activity;
  return {{"vertices", s.vertices},
          {"frames", s.frames},
          {"frame_duration", s.frame_duration},
          {"diagonal", s.diagonal},
          {"features", features},
          {"descriptors", cbor_of(s.events.descriptors)},
          {"places", cbor_of(s.events.places)},
          {"distances", s.events.distances},
          {"unit", s.events.unit},
          {"samples", a.samples},
          {"sample_duration", a.sample_duration},
          {"level", a.level},
          {"lags", a.lags},
          {"classes", a.classes},
          {"cyclic", a.is_cyclic},
          {"mean", a.mean},
          {"recurrence", a.recurrence},
          {"activity_places", a.places},
          {"period", a.cycle.period},
          {"strength", a.cycle.strength},
          {"pose_variation", a.pose_variation ? Cbor(*a.pose_variation) : Cbor(nullptr)}};
}

AMF::Animation_signature signature_of(const Cbor& j)
{
  AMF::Animation_signature s;
  j.at("vertices").get_to(s.vertices);
  j.at("frames").get_to(s.frames);
  j.at("frame_duration").get_to(s.frame_duration);
  j.at("diagonal").get_to(s.diagonal);
  for (const Cbor& f : j.at("features")) s.events.features.push_back(feature_of(f));
  s.events.descriptors = descriptors_of(j.at("descriptors"));
  s.events.places = descriptors_of(j.at("places"));
  j.at("distances").get_to(s.events.distances);
  j.at("unit").get_to(s.events.unit);
  if (j.at("cyclic").get<bool>()) s.events.loop = double(s.frames) * s.frame_duration;
  AMF::Activity& a = s.activity;
  j.at("samples").get_to(a.samples);
  j.at("sample_duration").get_to(a.sample_duration);
  j.at("level").get_to(a.level);
  j.at("lags").get_to(a.lags);
  j.at("classes").get_to(a.classes);
  j.at("cyclic").get_to(a.is_cyclic);
  j.at("mean").get_to(a.mean);
  j.at("recurrence").get_to(a.recurrence);
  j.at("activity_places").get_to(a.places);
  j.at("period").get_to(a.cycle.period);
  j.at("strength").get_to(a.cycle.strength);
  if (!j.at("pose_variation").is_null()) a.pose_variation = j.at("pose_variation").get<double>();
  const std::size_t m = s.events.features.size();
  if (s.events.distances.size() != m * m || s.events.descriptors.size() != m || s.events.places.size() != m ||
      a.mean.size() != a.samples || a.recurrence.size() != 2 * a.samples * a.lags ||
      a.places.size() != a.samples * a.classes)
    throw AMF::Input_error("sizes do not fit");
  return s;
}

// of letters, digits and a few signs, for the name of a file
std::string plain(std::string name)
{
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_') c = '_';
  return name.substr(0, 100);
}

} // namespace

Signature_cache::Signature_cache(const Item& item, const Settings& s)
{
  if (s.cache.empty()) return;
  Hash hash;
  for (const std::string& path : item.reading.paths()) add_path(path, hash);
  add_options(item, s, hash);
  fs::path first = item.reading.inputs.back();
  if (!first.has_filename()) first = first.parent_path();
  const fs::path folder = s.cache == "beside" ? first.parent_path() : fs::path(s.cache);
  m_path = (folder / (plain(item.name) + "." + hash.text() + ".signature")).string();
}

bool Signature_cache::find(AMF::Animation_signature& signature) const
{
  if (m_path.empty()) return false;
  std::ifstream is(m_path, std::ios::binary);
  if (!is) return false;
  const std::vector<char> bytes{std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>()};
  try {
    signature = signature_of(Cbor::from_cbor(bytes));
  } catch (const Cbor::exception&) {
    return false;
  } catch (const AMF::Input_error&) {
    return false;
  }
  return true;
}

void Signature_cache::keep(const AMF::Animation_signature& signature) const
{
  if (m_path.empty()) return;
  AMF::IO::Output_file file(m_path);
  const std::vector<std::uint8_t> bytes = Cbor::to_cbor(cbor_of(signature));
  file.stream().write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  file.commit();
}

} // namespace Compare_animations
