// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "compare_animations/commands.h"

#include "compare_animations/Analysed_animation.h"
#include "compare_animations/Item.h"
#include "compare_animations/make_signature.h"
#include "compare_animations/notices.h"
#include "output/Pair_page.h"
#include "running/Interruption.h"
#include "running/Progress_bar.h"
#include "running/counted.h"
#include "running/tell.h"

#include <CGAL/Animated_mesh_features/Applications/align_events.h>
#include <CGAL/Animated_mesh_features/Applications/animation_distance.h>
#include <CGAL/Animated_mesh_features/Applications/classical_scaling.h>
#include <CGAL/Animated_mesh_features/Applications/event_differences.h>
#include <CGAL/Animated_mesh_features/Applications/match_aligned_features.h>
#include <CGAL/Animated_mesh_features/IO/write_json.h>
#include <CGAL/Animated_mesh_features/IO/write_npy.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <locale>
#include <memory>
#include <numeric>
#include <sstream>

namespace AMF = CGAL::Animated_mesh_features;
using Programs::counted;

namespace Compare_animations {

namespace {

class Text
{
public:
  Text()
  {
    m_stream.imbue(std::locale::classic());
    m_stream << std::fixed;
  }
  Text& number(double x, int decimals, int width = 0)
  {
    m_stream << std::setprecision(decimals) << std::setw(width) << x;
    return *this;
  }
  template <class T>
  Text& operator<<(const T& x)
  {
    m_stream << x;
    return *this;
  }
  // to the right
  template <class T>
  Text& cell(const T& x, int width)
  {
    m_stream << std::setw(width) << x;
    return *this;
  }
  std::string str() const { return m_stream.str(); }

private:
  std::ostringstream m_stream;
};

Json json_of(const std::string& name, const Signature& s)
{
  return {{"name", name},
          {"vertices", s.vertices},
          {"frames", s.frames},
          {"frame_duration", s.frame_duration},
          {"features", s.events.features.size()},
          {"cyclic", s.activity.is_cyclic},
          {"period", s.activity.cycle.period},
          {"cycle_strength", s.activity.cycle.strength},
          {"pose_variation", s.activity.pose_variation ? Json(*s.activity.pose_variation) : Json(nullptr)}};
}

Json json_of(const AMF::Feature_match& m, const Signature& a, const Signature& b)
{
  const AMF::Feature_point &f = a.events.features[m.a], &g = b.events.features[m.b];
  return {{"a", m.a},
          {"b", m.b},
          {"confidence", m.confidence},
          {"difference", m.difference},
          {"vertex_a", f.vertex_index},
          {"vertex_b", g.vertex_index},
          {"time_a", f.time},
          {"time_b", g.time}};
}

Json json_of(const std::vector<AMF::Feature_match>& matches, const Signature& a, const Signature& b)
{
  Json all = Json::array();
  for (const AMF::Feature_match& m : matches) all.push_back(json_of(m, a, b));
  return all;
}

void add_matches(const std::vector<AMF::Feature_match>& matches, const Signature& a, const Signature& b, Text& text)
{
  const std::size_t most = 20;
  text << "\nmatched features: " << matches.size() << "\n";
  if (matches.empty()) return;
  text << "     A     B   confidence   time A   time B   vertex A   vertex B\n";
  for (std::size_t i = 0; i < (std::min)(most, matches.size()); ++i) {
    const AMF::Feature_point &f = a.events.features[matches[i].a], &g = b.events.features[matches[i].b];
    text.cell(matches[i].a, 6).cell(matches[i].b, 6).number(matches[i].confidence, 3, 13).number(f.time, 3, 9);
    text.number(g.time, 3, 9).cell(f.vertex_index, 11).cell(g.vertex_index, 11) << "\n";
  }
  if (matches.size() > most) text << "  ... and " << matches.size() - most << " more (--output has all of them)\n";
}

Json json_of(const std::optional<std::size_t>& rank)
{
  return rank ? Json(*rank) : Json(nullptr);
}

// Events that are in one take only, or differ in amplitude.
void add_differences(const std::vector<AMF::Event_difference>& differences, const Signature& a, const Signature& b,
                     const Settings& s, Result& result, Text& text)
{
  std::size_t exceeding = 0, shown = 0;
  const std::size_t most = 20;
  Json json = Json::array();
  Text rows;
  for (const AMF::Event_difference& d : differences) {
    const AMF::Feature_point& f = d.a ? a.events.features[*d.a] : b.events.features[*d.b];
    const std::string where = d.a && d.b ? "both" : d.a ? "A only" : "B only";
    const bool exceeds = d.amplitude > s.tolerance;
    exceeding += exceeds ? 1 : 0;
    json.push_back({{"in", where},
                    {"a", json_of(d.a)},
                    {"b", json_of(d.b)},
                    {"vertex", f.vertex_index},
                    {"time", f.time},
                    {"rest_position", f.rest_position},
                    {"sigma", f.sigma},
                    {"tau", f.tau},
                    {"difference", d.amplitude},
                    {"exceeds", exceeds}});
    if (!exceeds || ++shown > most) continue;
    rows << std::left;
    rows << "  ";
    rows.cell(where, 8);
    rows << std::right;
    rows.cell(f.vertex_index, 8).number(f.time, 3, 9).number(f.sigma, 4, 10).number(f.tau, 3, 8);
    rows.number(d.amplitude, 3, 12) << "\n";
  }
  result.json["differences"] = json;
  result.json["tolerance"] = s.tolerance;
  result.json["exceeding"] = exceeding;
  text << "\ndifferences of amplitude above " << s.tolerance << ": " << exceeding << " of " << differences.size()
       << " events\n";
  if (exceeding > 0) text << "  in        vertex     time     sigma     tau  difference\n" << rows.str();
  if (shown > most) text << "  ... and " << shown - most << " more (--output has all of them)\n";
  if (s.check && exceeding > 0)
    result.failure = counted(exceeding, "event differs", "events differ") + " by more than the tolerance";
}

Json ranks(const std::vector<std::size_t>& v)
{
  return Json(v);
}

// all distances of pairs, in the order of the items
Distance_matrix matrix_of(const std::vector<Item>& items, const std::vector<Signature>& signatures, const Settings& s)
{
  Distance_matrix m;
  for (const Item& i : items) m.names.push_back(i.name);
  const std::size_t n = m.size();
  m.distances.assign(n * n, 0);
  Programs::Progress_bar bar(!s.run.quiet);
  for (std::size_t i = 0; i < n; ++i) {
    bar.show("distances", double(i) / double(n));
    AMF::parallel_for<CGAL::Parallel_if_available_tag>(i + 1, n, [&](std::size_t j) {
      m.distances[i * n + j] = m.distances[j * n + i] =
          AMF::animation_distance(signatures[i].activity, signatures[j].activity, s.distance);
    });
    Programs::Interruption::check();
  }
  m.places = AMF::classical_scaling(m.distances, n);
  return m;
}

} // namespace

Result compare_pair(const Settings& s)
{
  Result result;
  Signature signatures[2];
  std::string names[2];
  std::unique_ptr<Analysed_animation> animations[2];
  std::vector<Item> items = {item(s.words[0], s.reading), item(s.words[1], s.reading)};
  tell_apart(items[0], items[1]);
  for (int i = 0; i < 2; ++i) {
    const Item& one = items[std::size_t(i)];
    names[i] = one.name;
    if (s.html.empty())
      signatures[i] = make_signature(one, s);
    else if (one.feature_file.empty())
      signatures[i] = make_signature(one, s, animations[i]);
    else
      throw AMF::Option_error("--html: " + one.feature_file +
                              " is a file of features alone; there is no surface to be shown, name the animation");
    Programs::Interruption::check();
  }
  const Signature &a = signatures[0], &b = signatures[1];
  if (!s.run.quiet) Programs::tell(notice_of_kinds(items) + notice_of_clocks(a, b));
  const AMF::Time_alignment alignment = AMF::align_animations(a.activity, b.activity, s.alignment);
  const double distance = AMF::animation_distance(a.activity, b.activity, s.distance);
  const std::vector<AMF::Feature_match> matches = AMF::match_aligned_features(a, b, alignment, s.matching);
  const AMF::Event_alignment events = AMF::align_events(a.events, b.events, alignment);
  const std::vector<AMF::Event_difference> differences = AMF::event_differences(a, b, alignment, s.gates);

  result.json = {
      {"comparison", "pair"}, {"a", json_of(names[0], a)}, {"b", json_of(names[1], b)}, {"distance", distance}};
  result.json["alignment"] = {{"cost", alignment.cost},
                              {"confidence", alignment.confidence},
                              {"phase", alignment.phase ? Json(*alignment.phase) : Json(nullptr)},
                              {"loops", {alignment.period_a, alignment.period_b}},
                              {"times_a", alignment.times_a},
                              {"times_b", alignment.times_b}};
  result.json["matches"] = json_of(matches, a, b);
  result.json["events"] = {{"score", events.score},
                           {"pairs", json_of(events.pairs, a, b)},
                           {"only_a", ranks(events.only_a)},
                           {"only_b", ranks(events.only_b)}};
  Text text;
  for (int i = 0; i < 2; ++i) {
    const Signature& x = signatures[i];
    text << (i == 0 ? "A: " : "B: ") << names[i] << ", " << counted(x.events.features.size(), "feature", "features")
         << ", ";
    text.number(double(x.frames) * x.frame_duration, 3) << " s";
    if (x.activity.is_cyclic) text << ", a loop";
    if (x.activity.cycle.period > 0 && !(x.activity.is_cyclic && x.activity.cycle.period == x.activity.duration())) {
      text << ", repeats itself after ";
      text.number(x.activity.cycle.period, 3) << " s";
    }
    text << "\n";
    if (x.events.features.empty()) text << "   there are no features: nothing can be matched\n";
  }
  text << "\ndistance:             ";
  text.number(distance, 3) << "\nalignment, cost:      ";
  text.number(alignment.cost, 3) << "\n           confidence: ";
  text.number(alignment.confidence, 3);
  if (alignment.phase) {
    text << "\n           phase of B: ";
    text.number(*alignment.phase, 3) << (a.activity.is_cyclic && b.activity.is_cyclic ? " of the loop ahead"
                                                                                      : " of a period ahead");
  }
  text << "\n\n    time A   time B\n";
  const int rows = 8;
  for (int i = 0; i <= rows; ++i) {
    const double t = a.activity.duration() * i / rows;
    text.number(t, 3, 10).number(alignment.to_b(t), 3, 9) << "\n";
  }
  add_matches(matches, a, b, text);
  text << "\nevents in the same order: " << events.pairs.size() << ", of A only " << events.only_a.size()
       << ", of B only " << events.only_b.size() << "\n";
  add_differences(differences, a, b, s, result, text);
  if (!s.html.empty())
    result.page =
        Programs::pair_page(animations[0]->scene(s.matching.top), animations[1]->scene(s.matching.top), result.json);
  result.text = text.str();
  return result;
}

Result compare_all(const Settings& s)
{
  Result result;
  std::vector<Item> items = collection(s.words, s.reading);
  std::vector<Signature> signatures;
  result.broken = make_signatures(items, signatures, s);
  if (!s.run.quiet) Programs::tell(notice_of_kinds(items));
  if (items.size() < 2)
    throw AMF::Input_error("the collection has " + counted(items.size(), "animation", "animations") +
                           " that can be read; at least two are compared");
  result.matrix = matrix_of(items, signatures, s);
  const Distance_matrix& m = *result.matrix;
  Json animations = Json::array(), rows = Json::array();
  for (std::size_t i = 0; i < m.size(); ++i) {
    animations.push_back(json_of(m.names[i], signatures[i]));
    rows.push_back(std::vector<double>(m.distances.begin() + std::ptrdiff_t(i * m.size()),
                                       m.distances.begin() + std::ptrdiff_t((i + 1) * m.size())));
  }
  result.json = {{"comparison", "matrix"},
                 {"animations", animations},
                 {"distances", rows},
                 {"embedding", m.places},
                 {"left_out", result.broken}};
  Text text;
  text << counted(m.size(), "animation", "animations") << "; the nearest of each:\n";
  std::size_t width = 4;
  for (const std::string& n : m.names) width = (std::max)(width, n.size());
  for (std::size_t i = 0; i < m.size(); ++i) {
    std::size_t best = i == 0 ? 1 : 0;
    for (std::size_t j = 0; j < m.size(); ++j)
      if (j != i && m(i, j) < m(i, best)) best = j;
    text << "  " << m.names[i] << std::string(width + 2 - m.names[i].size(), ' ');
    text.number(m(i, best), 3) << "  " << m.names[best] << "\n";
  }
  result.text = text.str();
  return result;
}

Result rank(const Settings& s)
{
  Result result;
  const Item one = item(s.words.front(), s.reading);
  const Signature query = make_signature(one, s);
  std::vector<Item> items = collection({s.words.begin() + 1, s.words.end()}, s.reading);
  std::vector<Signature> signatures;
  result.broken = make_signatures(items, signatures, s);
  std::vector<Item> all = items;
  all.push_back(one);
  if (!s.run.quiet) Programs::tell(notice_of_kinds(all));
  if (items.empty()) throw AMF::Input_error("nothing of the collection can be read");
  std::vector<double> distances;
  for (const Signature& x : signatures)
    distances.push_back(AMF::animation_distance(query.activity, x.activity, s.distance));
  std::vector<std::size_t> order(items.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return distances[i] < distances[j]; });
  Json ranking = Json::array();
  Text text;
  text << one.name << " and the others, the nearest first:\n";
  for (std::size_t i : order) {
    ranking.push_back({{"name", items[i].name}, {"distance", distances[i]}});
    text << "  ";
    text.number(distances[i], 3) << "  " << items[i].name << "\n";
  }
  result.json = {
      {"comparison", "query"}, {"query", json_of(one.name, query)}, {"ranking", ranking}, {"left_out", result.broken}};
  result.text = text.str();
  return result;
}

Result describe(const Settings& s, std::string& descriptors)
{
  Result result;
  const Item one = item(s.words.front(), s.reading);
  if (!one.feature_file.empty())
    throw AMF::Option_error(one.feature_file +
                            ": a file of features alone has no field that could be described; name the "
                            "animation");
  const Signature x = make_signature(one, s);
  const AMF::Feature_descriptors& d = x.events.descriptors;
  result.json = json_of(one.name, x);
  result.json["comparison"] = "description";
  result.json["descriptor"] = s.is_oriented ? "oriented" : "rotation-free";
  result.json["length"] = d.length();
  Json features = Json::array();
  AMF::Spatio_temporal_field<float> array(d.size(), d.length());
  for (std::size_t i = 0; i < d.size(); ++i) {
    Json f = x.events.features[i];
    f["descriptor"] = std::vector<float>(d[i], d[i] + d.length());
    features.push_back(f);
    for (std::size_t k = 0; k < d.length(); ++k) array(i, k) = d[i][k];
  }
  result.json["features"] = features;
  std::ostringstream npy;
  AMF::IO::write_npy(npy, array);
  descriptors = npy.str();
  result.text = one.name + ": " + counted(d.size(), "feature", "features") + ", each described by " +
                std::to_string(d.length()) + " numbers\n";
  return result;
}

} // namespace Compare_animations
