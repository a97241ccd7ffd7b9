// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line program of the package: an animation in files goes in, a file of its spatio-temporal feature points
// comes out. Results go to files or to the standard output, messages to the standard error output.

#include "reading/Animation.h"
#include "detect_features/Command_line.h"
#include "output/Html_file.h"
#include "detect_features/Interruption.h"
#include "reading/Memory_plan.h"
#include "detect_features/Monitor.h"
#include "output/Result_files.h"
#include "detect_features/Stage_log.h"
#include "detect_features/detect.h"
#include "detect_features/report.h"
#include "detect_features/short_usage.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/config.h>

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/global_control.h>
#endif

#include <cstddef>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <stdexcept>

using namespace Detect_features;
namespace AMF = CGAL::Animated_mesh_features;

namespace {

enum Exit_code
{
  SUCCESS = 0,
  FAILURE = 1, // whatever the user cannot help: out of memory, for instance
  BAD_USAGE = 2,
  BAD_INPUT = 3,
  CANNOT_WRITE = 4,
  INTERRUPTED = 128 // plus the number of the signal, as shells have it
};

void print_version()
{
  std::cout << "detect_features " << ANIMATED_MESH_FEATURES_VERSION << " (CGAL " << CGAL_VERSION_STR
#ifdef CGAL_LINKED_WITH_TBB
            << ", with oneTBB)"
#else
            << ", without oneTBB: one thread)"
#endif
            << std::endl;
}

// As many threads as the command line allows, as long as it lives.
class Thread_limit
{
public:
  explicit Thread_limit(std::size_t threads)
  {
#ifdef CGAL_LINKED_WITH_TBB
    if (threads > 0) m_limit.emplace(tbb::global_control::max_allowed_parallelism, threads);
#else
    (void)threads;
#endif
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  std::optional<tbb::global_control> m_limit;
#endif
};

void throw_if_interrupted()
{
  if (Interruption::signal() != 0) throw AMF::Cancelled();
}

void run(const Command_line& command_line)
{
  const Thread_limit thread_limit(command_line.threads);
  Stage_log log;
  log.begin("reading");
  Memory_plan memory_plan(command_line.memory, command_line.scratch_directory);
  const Animation animation(command_line, [&](std::size_t vertices, std::size_t frames) {
    check_html(command_line, vertices, frames);
    return memory_plan.decide(vertices, frames, command_line.extra_fields());
  });
  log.end();
  // now rather than after hours of computation
  Programs::check_picture_frames(command_line.picture, animation.sequence().number_of_frames());
  if (command_line.verbose)
    std::cerr << animation_report(command_line, animation) << memory_plan.report() << '\n' << std::flush;

  const std::string notices =
      clip_notice(command_line, animation) + counts_notice(animation.sequence(), command_line);
  if (!command_line.quiet) std::cerr << notices << std::flush;

  const Interruption interruption; // before there is anything to be left behind
  Result_files files(command_line);
  Detection detection;
  {
    Monitor monitor(log, !command_line.quiet);
    detection = detect(animation.sequence(), command_line, memory_plan.level_memory(), files, monitor);
  }
  throw_if_interrupted();
  {
    const Stage_log::Scope stage(log, "writing");
    files.write_features(detection.features, description(command_line, animation, detection));
    throw_if_interrupted();
    files.write_scenes(scene(command_line, animation, detection));
    throw_if_interrupted();
    files.commit();
  }
  if (command_line.verbose) std::cerr << detection_report(detection) << stage_report(log);
  if (!command_line.quiet) std::cerr << summary(command_line, detection, log.total_seconds()) << std::flush;
}

int failed(const std::exception& e, int exit_code)
{
  // Waiting for the reader of a pipe ends by an error, too.
  if (Interruption::signal() != 0) {
    std::cerr << "detect_features: interrupted" << std::endl;
    return INTERRUPTED + Interruption::signal();
  }
  std::cerr << "detect_features: " << e.what() << std::endl;
  if (exit_code == BAD_USAGE) std::cerr << "Try detect_features --help" << std::endl;
  return exit_code;
}

} // namespace

int main(int argc, char* argv[])
{
  // The standard output is for results: a script that lost its arguments must not take this for one.
  if (argc <= 1) {
    std::cerr << short_usage();
    return BAD_USAGE;
  }
  try {
    const Command_line command_line = parse_command_line(argc, argv);
    if (command_line.help)
      std::cout << full_usage() << std::flush;
    else if (command_line.version)
      print_version();
    else
      run(command_line);
    return std::cout ? SUCCESS : CANNOT_WRITE;
  } catch (const AMF::Option_error& e) {
    return failed(e, BAD_USAGE);
  } catch (const AMF::Input_error& e) {
    return failed(e, BAD_INPUT);
  } catch (const AMF::Output_error& e) {
    return failed(e, CANNOT_WRITE);
  } catch (const std::bad_alloc&) {
    return failed(std::runtime_error("out of memory"), FAILURE);
  } catch (const std::exception& e) {
    return failed(e, FAILURE);
  }
}
