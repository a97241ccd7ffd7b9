// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_SUPPORT_H
#define CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_SUPPORT_H

#include <CGAL/config.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/global_control.h>
  #include <tbb/parallel_for.h>
  #include <tbb/version.h>
#endif

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

// What the benchmarks share: time, memory, threads, and tables on the terminal and as JSON.

namespace Benchmark {

// ------------------------------------------------------------------------------------------------------- command line

struct Arguments
{
  bool quick = false; // sizes and repetitions that only show that everything works
  std::string data;   // a folder with real animations, or empty
  std::string hand;   // the mesh of a hand that moves, its point cache beside it, or empty
  std::string json;   // where to write, or empty

  Arguments(int argc, char* argv[])
  {
    for (int i = 1; i < argc; ++i) {
      const std::string a = argv[i];
      if (a == "--quick")
        quick = true;
      else if ((a == "--data" || a == "--hand" || a == "--json") && i + 1 < argc)
        (a == "--data" ? data : a == "--hand" ? hand : json) = argv[++i];
      else
        throw std::invalid_argument("usage: " + std::string(argv[0]) +
                                    " [--quick] [--data DIR] [--hand FILE.obj] [--json FILE]");
    }
  }
};

// --------------------------------------------------------------------------------------------------------------- time

template <class Function>
double seconds_of(const Function& f)
{
  const auto start = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Repetitions
{
  std::size_t least, most;
  double seconds; // no further round begins after this time
};

inline Repetitions repetitions(const Arguments& a)
{
  return a.quick ? Repetitions{1, 3, 0.1} : Repetitions{3, 20, 2};
}

// The least time of each of several functions. They run in turn, round by round, so that whatever else the machine does
// meets all of them.
inline std::vector<double> least_seconds(const std::vector<std::function<void()>>& functions, const Repetitions& r)
{
  std::vector<double> least(functions.size(), std::numeric_limits<double>::infinity());
  double total = 0;
  for (std::size_t i = 0; i < r.most && (i < r.least || total < r.seconds); ++i)
    for (std::size_t j = 0; j < functions.size(); ++j) {
      const double t = seconds_of(functions[j]);
      least[j] = (std::min)(least[j], t);
      total += t;
    }
  return least;
}

inline double least_seconds(const std::function<void()>& f, const Repetitions& r)
{
  return least_seconds(std::vector<std::function<void()>>{f}, r)[0];
}

// ------------------------------------------------------------------------------------------------------------ threads

inline std::size_t number_of_cores()
{
  return (std::max)(1u, std::thread::hardware_concurrency());
}

// 1 and all, where there are several.
inline std::vector<std::size_t> thread_counts()
{
  std::vector<std::size_t> counts = {1};
#ifdef CGAL_LINKED_WITH_TBB
  if (number_of_cores() > 1) counts.push_back(number_of_cores());
#endif
  return counts;
}

// At most so many threads in what the package runs, as long as this lives.
class Thread_limit
{
public:
  explicit Thread_limit(std::size_t n)
#ifdef CGAL_LINKED_WITH_TBB
    : m_control(tbb::global_control::max_allowed_parallelism, n)
#endif
  {
    (void)n;
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  tbb::global_control m_control;
#endif
};

// Keeps the package on one thread, so that a child process can be made; ends in the child.
inline std::unique_ptr<Thread_limit>& limit_before_child_processes()
{
  static std::unique_ptr<Thread_limit> limit;
  return limit;
}

// The loop that policies are given, see the concept GeodesicBalls, for calling one without a detector.
struct Policy_loop
{
  template <class Task>
  void operator()(std::size_t n, const Task& task) const
  {
#ifdef CGAL_LINKED_WITH_TBB
    tbb::parallel_for(std::size_t(0), n, task);
#else
    for (std::size_t i = 0; i < n; ++i) task(i);
#endif
  }
  Policy_loop part(std::size_t, std::size_t) const
  {
    return *this;
  }
};

// ------------------------------------------------------------------------------------------------------------- memory

// A line such as "VmHWM:  1234 kB" of Linux' account of this process, in bytes; 0 where there is no such account.
inline double process_memory(const char* name)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.compare(0, std::strlen(name), name) == 0) return 1024 * std::atof(line.c_str() + std::strlen(name) + 1);
  return 0;
}

// The most memory that was in use since the construction, over what was in use then.
class Peak_memory
{
public:
  Peak_memory()
  {
    std::ofstream("/proc/self/clear_refs") << 5; // sets the peak to what is in use now
    m_before = process_memory("VmRSS");
  }
  double bytes() const { return (std::max)(0., process_memory("VmHWM") - m_before); }

private:
  double m_before;
};

// Runs f in a child process and returns what it returns: a name and a number each. What is measured there does not meet
// the memory that earlier measurements left behind. No threads must have been started before, see above.
inline std::map<std::string, double> in_child_process(const std::function<std::map<std::string, double>()>& f)
{
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe to a child process");
  std::cout.flush();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no child process");
  if (child == 0) {
    close(ends[0]);
    int result = EXIT_SUCCESS;
    try {
      limit_before_child_processes().reset(); // or it would hold here as well
      std::ostringstream os;
      os << std::setprecision(17);
      for (const auto& value : f()) os << value.first << ' ' << value.second << '\n';
      const std::string text = os.str();
      if (write(ends[1], text.data(), text.size()) != ssize_t(text.size())) result = EXIT_FAILURE;
    } catch (const std::exception& e) {
      std::cerr << e.what() << std::endl;
      result = EXIT_FAILURE;
    }
    _exit(result);
  }
  close(ends[1]);
  std::string text;
  char buffer[4096];
  for (ssize_t n; (n = read(ends[0], buffer, sizeof buffer)) > 0;) text.append(buffer, std::size_t(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != EXIT_SUCCESS) throw std::runtime_error("a child process failed");
  std::map<std::string, double> values;
  std::istringstream is(text);
  std::string name;
  for (double value; is >> name >> value;) values[name] = value;
  return values;
}

// ------------------------------------------------------------------------------------------------------------- tables

// Nothing, a text, a count or a measured number.
struct Cell
{
  enum Kind
  {
    NOTHING,
    TEXT,
    COUNT,
    NUMBER
  };
  Kind kind = NOTHING;
  std::string text;
  double number = 0;

  Cell() = default;
  Cell(const char* t)
    : kind(TEXT)
    , text(t)
  {}
  Cell(std::string t)
    : kind(TEXT)
    , text(std::move(t))
  {}
  Cell(int n)
    : kind(COUNT)
    , number(n)
  {}
  Cell(std::size_t n)
    : kind(COUNT)
    , number(double(n))
  {}
  Cell(double x)
    : kind(NUMBER)
    , number(x)
  {}
};

inline std::string shown(const Cell& c)
{
  if (c.kind == Cell::NOTHING || c.kind == Cell::TEXT) return c.text;
  std::ostringstream os;
  const double size = std::abs(c.number);
  if (c.kind == Cell::COUNT || (size >= 100 && size < 1e7))
    os << std::fixed << std::setprecision(0) << c.number;
  else
    os << std::setprecision(3) << c.number;
  return os.str();
}

inline std::string json_string(const std::string& s)
{
  std::string result = "\"";
  for (char c : s) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) < ' ')
      result += ' ';
    else
      result += c;
  }
  return result + '"';
}

inline std::string json(const Cell& c)
{
  if (c.kind == Cell::TEXT) return json_string(c.text);
  if (c.kind == Cell::COUNT) return shown(c);
  if (c.kind == Cell::NOTHING || !std::isfinite(c.number)) return "null";
  std::ostringstream os;
  os << std::setprecision(8) << c.number;
  const std::string text = os.str();
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text; // else a reader would take it for a count
}

// A table with a title, and a note on how its figures came about.
class Table
{
public:
  Table(std::string title, std::string note, std::vector<std::string> columns)
    : m_title(std::move(title))
    , m_note(std::move(note))
    , m_columns(std::move(columns))
  {}

  template <class... T>
  void add(const T&... values)
  {
    m_rows.push_back({Cell(values)...});
    if (m_rows.back().size() != m_columns.size()) throw std::logic_error("row and columns of a table differ");
    std::cerr << '.' << std::flush; // a long run shows that it goes on
  }

  void print(std::ostream& os) const
  {
    std::vector<std::size_t> widths;
    for (std::size_t c = 0; c < m_columns.size(); ++c) {
      std::size_t width = m_columns[c].size();
      for (const auto& row : m_rows) width = (std::max)(width, shown(row[c]).size());
      widths.push_back(width);
    }
    os << "\n== " << m_title << "\n" << m_note << "\n\n";
    for (std::size_t c = 0; c < m_columns.size(); ++c) os << std::setw(int(widths[c]) + 2) << m_columns[c];
    os << '\n';
    for (const auto& row : m_rows) {
      for (std::size_t c = 0; c < row.size(); ++c)
        os << (c == 0 ? "  " : "") << (c == 0 ? std::left : std::right) << std::setw(int(widths[c]) + (c == 0 ? 0 : 2))
           << shown(row[c]) << std::right;
      os << '\n';
    }
    os << std::flush;
  }

  void write(std::ostream& os) const
  {
    os << "{\"title\": " << json_string(m_title) << ", \"note\": " << json_string(m_note) << ",\n   \"columns\": [";
    for (std::size_t c = 0; c < m_columns.size(); ++c) os << (c ? ", " : "") << json_string(m_columns[c]);
    os << "],\n   \"rows\": [";
    for (std::size_t r = 0; r < m_rows.size(); ++r) {
      os << (r ? ",\n    [" : "\n    [");
      for (std::size_t c = 0; c < m_rows[r].size(); ++c) os << (c ? ", " : "") << json(m_rows[r][c]);
      os << "]";
    }
    os << "]}";
  }

private:
  std::string m_title, m_note;
  std::vector<std::string> m_columns;
  std::vector<std::vector<Cell>> m_rows;
};

inline std::string compiler()
{
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "unknown";
#endif
}

inline std::string tbb_version()
{
#ifdef CGAL_LINKED_WITH_TBB
  return std::to_string(TBB_VERSION_MAJOR) + "." + std::to_string(TBB_VERSION_MINOR);
#else
  return "none";
#endif
}

// Prints tables as they come, and writes all of them at the end.
class Report
{
public:
  Report(std::string name, const Arguments& arguments)
    : m_name(std::move(name))
    , m_arguments(arguments)
  {}

  void add(const Table& table)
  {
    std::cerr << '\n';
    table.print(std::cout);
    m_tables.push_back(table);
  }

  int finish() const
  {
    if (m_arguments.json.empty()) return EXIT_SUCCESS;
    std::ofstream os(m_arguments.json);
    os << "{\"program\": " << json_string(m_name) << ",\n \"quick\": " << (m_arguments.quick ? "true" : "false")
       << ",\n \"compiler\": " << json_string(compiler()) << ",\n \"cgal\": " << json_string(CGAL_VERSION_STR)
       << ",\n \"eigen\": \"" << EIGEN_WORLD_VERSION << '.' << EIGEN_MAJOR_VERSION << '.' << EIGEN_MINOR_VERSION
       << "\",\n \"tbb\": " << json_string(tbb_version()) << ",\n \"tables\": [";
    for (std::size_t i = 0; i < m_tables.size(); ++i) {
      os << (i ? ",\n  " : "\n  ");
      m_tables[i].write(os);
    }
    os << "]}\n";
    os.close();
    if (os) return EXIT_SUCCESS;
    std::cerr << m_arguments.json << ": cannot be written" << std::endl;
    return EXIT_FAILURE;
  }

private:
  std::string m_name;
  Arguments m_arguments;
  std::vector<Table> m_tables;
};

// The body of main().
template <class Function>
int run(const char* name, int argc, char* argv[], const Function& f)
{
  try {
    const Arguments arguments(argc, argv);
    Report report(name, arguments);
    f(arguments, report);
    return report.finish();
  } catch (const std::exception& e) {
    std::cerr << argv[0] << ": " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}

} // namespace Benchmark

#endif // CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_SUPPORT_H
