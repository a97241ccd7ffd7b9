// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/run_all_clips.h"

#include "detect_features/clip_table.h"
#include "detect_features/run.h"
#include "output/check_outputs.h"
#include "output/clip_outputs.h"
#include "reading/Model_file.h"
#include "running/Interruption.h"
#include "running/counted.h"
#include "running/tell.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
using namespace Programs;

namespace Detect_features {

namespace {

// What reads and writes each clip alone.
std::vector<Command_line> command_lines(const Command_line& c, const std::vector<std::string>& clips)
{
  const std::vector<std::string> names = clip_file_names(clips);
  std::vector<Command_line> result;
  std::vector<std::string> outputs;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    result.push_back(c);
    result.back().reading.clip = std::to_string(i);
    if (std::count(clips.begin(), clips.end(), clips[i]) == 1 && !clips[i].empty())
      result.back().reading.clip = clips[i];
    result.back().output = outputs_of_clip(c.output, names[i]);
    const std::vector<std::string> paths = result.back().output.paths();
    outputs.insert(outputs.end(), paths.begin(), paths.end());
  }
  check_outputs(outputs, c.reading.paths());
  make_folders(outputs);
  return result;
}

std::string last_line(const Command_line& c, const std::vector<Clip_outcome>& outcomes, double seconds)
{
  std::size_t features = 0;
  for (const Clip_outcome& o : outcomes) features += o.outcome.features;
  std::ostringstream os;
  os << counted(outcomes.size(), "clip", "clips") << ", " << counted(features, "feature", "features") << ", in "
     << std::fixed << std::setprecision(1) << seconds << " s";
  const char* separator = "; written to ";
  for (const std::string& path : c.output.paths()) {
    os << separator << path;
    separator = ", ";
  }
  os << '\n';
  return os.str();
}

} // namespace

void run_all_clips(const Command_line& c)
{
  CGAL::Real_timer timer;
  timer.start();
  const std::vector<std::string> clips = clip_names(c.reading);
  const std::vector<Command_line> commands = command_lines(c, clips);
  std::vector<Clip_outcome> outcomes;
  std::string failed;
  std::size_t number_failed = 0, of_options = 0;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const std::string name = clips[i].empty() ? std::to_string(i) : clips[i];
    outcomes.push_back({name, {}, ""});
    const auto fail = [&](const std::string& message) {
      Interruption::check(); // waiting that was interrupted is not the clip's fault
      outcomes.back().failure = message;
      failed += (number_failed++ == 0 ? "" : ", ") + name;
      tell("detect_features: " + name + " is left out: " + message + "\n");
    };
    try {
      outcomes.back().outcome =
          run(commands[i], name + ": ",
              "clip " + std::to_string(i + 1) + " of " + std::to_string(clips.size()) + ", " + name + ": ");
    } catch (const AMF::Cancelled&) {
      throw;
    } catch (const AMF::Output_error&) {
      throw;
    } catch (const AMF::Option_error& e) {
      ++of_options;
      fail(e.what());
    } catch (const AMF::Error& e) {
      fail(e.what());
    }
    Interruption::check();
  }
  std::cout << clip_table(outcomes) << std::flush;
  if (!c.run.quiet) tell(last_line(c, outcomes, timer.time()));
  if (number_failed == 0) return;
  const std::string message =
      std::to_string(number_failed) + " of " + counted(clips.size(), "clip", "clips") + " left out: " + failed;
  if (of_options == clips.size()) throw AMF::Option_error(message);
  throw AMF::Input_error(message);
}

} // namespace Detect_features
