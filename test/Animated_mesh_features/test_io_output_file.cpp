// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Output_file: all or nothing, nothing left behind, and every error told.

#include "test_io_support.h"

#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <stdexcept>
#include <string>

#ifdef __unix__
  #include <csignal>
  #include <fcntl.h>
  #include <sys/resource.h>
  #include <sys/stat.h>
  #include <sys/wait.h>
  #include <unistd.h>
#endif

using namespace CGAL::Animated_mesh_features;
using namespace test_support;

namespace {

namespace fs = std::filesystem;

const std::string text = "first line\nsecond line\n";

void write(const std::string& path, const std::string& content = text)
{
  IO::Output_file file(path);
  file.stream() << content;
  file.commit();
}

void test_new_and_old_files()
{
  const Temporary_folder folder;
  write(folder.path("new"));
  CHECK(folder.read("new") == text);
  write(folder.path("new"), "");
  CHECK(folder.read("new").empty());
  std::string all_bytes;
  for (int i = 0; i < 300000; ++i) all_bytes += char(i % 251);
  write(folder.path("new"), all_bytes);
  CHECK(folder.read("new") == all_bytes);
  write(folder.path(std::string(250, 'n'))); // as long as names may nearly be
  CHECK(folder.read(std::string(250, 'n')) == text);
  CHECK(folder.number_of_entries() == 2);

  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  write("relative");
  fs::current_path(before);
  CHECK(folder.read("relative") == text);
}

void test_exception_midway()
{
  const Temporary_folder folder;
  folder.write("old", "old contents");
  for (const char* name : {"old", "new"}) {
    try {
      IO::Output_file file(folder.path(name));
      file.stream() << text << std::flush;
      CHECK(folder.number_of_entries() == 2); // the temporary is in the same folder
      CHECK(folder.read("old") == "old contents");
      throw std::runtime_error("midway");
    } catch (const std::runtime_error&) {}
    CHECK(folder.number_of_entries() == 1);
    CHECK(folder.read("old") == "old contents");
  }

  IO::Output_file file(folder.path("old"));
  file.stream() << text;
  file.commit();
  CHECK(folder.read("old") == text);
  CHECK_THROWS(Output_error, file.commit(), "old: cannot write: ");
  file.stream() << "more" << std::flush;
  CHECK(file.stream().fail());
  CHECK(folder.read("old") == text);
}

void test_errors()
{
  const Temporary_folder folder;
  CHECK_THROWS(Output_error, write(folder.path("none/file")),
               folder.path("none/file") + ": cannot write: No such file");
  CHECK_THROWS(Output_error, write(folder.path()), folder.path() + ": cannot write: Is a directory");
  CHECK_THROWS(Output_error, write(""), ": cannot write: ");
  CHECK(folder.number_of_entries() == 0);

  // The name becomes a folder meanwhile: the rename fails.
  {
    IO::Output_file file(folder.path("late"));
    file.stream() << text;
    fs::create_directories(folder.path("late/inner"));
    CHECK_THROWS(Output_error, file.commit(), folder.path("late") + ": cannot write: ");
  }
  CHECK(folder.number_of_entries() == 1);
}

#ifdef __unix__

mode_t mode(const std::string& path)
{
  struct stat s;
  return stat(path.c_str(), &s) == 0 ? s.st_mode & 07777 : 0;
}

void test_permissions()
{
  const Temporary_folder folder;
  const mode_t before = umask(027);
  write(folder.path("new"));
  CHECK(mode(folder.path("new")) == 0640);
  umask(before);
  folder.write("old", "old");
  chmod(folder.path("old").c_str(), 0751);
  {
    IO::Output_file file(folder.path("old"));
    for (const auto& entry : fs::directory_iterator(folder.path()))
      if (entry.path().extension() == ".tmp") CHECK(mode(entry.path().string()) == 0751); // from the start
    file.commit();
  }
  CHECK(mode(folder.path("old")) == 0751);

  folder.write("protected", "old");
  chmod(folder.path("protected").c_str(), 0444);
  if (geteuid() != 0) { // to root nothing is protected
    CHECK_THROWS(Output_error, write(folder.path("protected")), "protected: cannot write: Permission denied");
    CHECK(folder.read("protected") == "old");
  }
  CHECK(folder.number_of_entries() == 3);
}

void test_links()
{
  const Temporary_folder folder;
  folder.write("a/target", "old");
  fs::create_symlink("a/target", folder.path("link"));
  fs::create_symlink("link", folder.path("link_to_link"));
  fs::create_symlink(folder.path("a/new"), folder.path("dangling"));
  fs::create_symlink("loop", folder.path("loop"));
  write(folder.path("link_to_link"));
  write(folder.path("dangling"));
  CHECK(fs::is_symlink(folder.path("link")) && fs::is_symlink(folder.path("link_to_link")) &&
        fs::is_symlink(folder.path("dangling")));
  CHECK(folder.read("a/target") == text);
  CHECK(folder.read("a/new") == text);
  CHECK_THROWS(Output_error, write(folder.path("loop")), "loop: cannot write: Too many levels of symbolic links");
  CHECK(folder.number_of_entries() == 5);
}

// A process that is killed leaves its temporary; the next one for the same file removes it, but none that is in use.
void test_leftovers()
{
  const Temporary_folder folder;
  const std::string killed = ".x.json.123.tmp", other = ".y.json.123.tmp", similar = ".x.json.12a.tmp";
  for (const std::string& name : {killed, other, similar}) folder.write(name, "left");
  folder.write(".x.json.7.tmp/inner/file", "left by a folder");
  fs::create_symlink("keep", folder.path(".x.json.8.tmp"));
  CHECK(mkfifo(folder.path(".x.json.9.tmp").c_str(), 0600) == 0); // is not ours, and not waited for
  {
    IO::Output_file first(folder.path("x.json")), second(folder.path("x.json"), IO::Output_sync::NEVER);
    CHECK(!fs::exists(folder.path(killed)) && !fs::exists(folder.path(".x.json.7.tmp")));
    first.stream() << "first";
    second.stream() << "second";
    first.commit();
    CHECK(folder.read("x.json") == "first");
    write(folder.path("x.json"), "third");
    second.commit(); // is still there
    CHECK(folder.read("x.json") == "second");
  }
  CHECK(folder.read(other) == "left" && folder.read(similar) == "left");
  CHECK(folder.number_of_entries() == 5);
}

// A writer that is killed indeed.
void test_killed_writer()
{
  const Temporary_folder folder;
  const pid_t child = fork();
  if (child == 0) {
    IO::Output_file file(folder.path("x"));
    file.stream() << text << std::flush;
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(WIFSIGNALED(status) && folder.number_of_entries() == 1 && !fs::exists(folder.path("x")));
  write(folder.path("x"));
  CHECK(folder.read("x") == text && folder.number_of_entries() == 1);
}

// The file size limit stands in for a full disk.
void test_full_disk()
{
  const Temporary_folder folder;
  folder.write("old", "old contents");
  rlimit old_limit;
  getrlimit(RLIMIT_FSIZE, &old_limit);
  rlimit limit = old_limit;
  limit.rlim_cur = 100000;
  std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &limit);
  {
    IO::Output_file file(folder.path("old"));
    file.stream() << std::string(50000, 'x');
    file.check();
    file.stream() << std::string(100000, 'x') << std::flush;
    CHECK_THROWS(Output_error, file.check(), folder.path("old") + ": cannot write: File too large");
    file.stream().clear(); // an error cannot be talked away
    CHECK_THROWS(Output_error, file.commit(), folder.path("old") + ": cannot write: File too large");
  }
  CHECK_THROWS(Output_error, write(folder.path("old"), std::string(100001, 'x')), "File too large");
  setrlimit(RLIMIT_FSIZE, &old_limit);
  CHECK(folder.read("old") == "old contents");
  CHECK(folder.number_of_entries() == 1);
}

void test_special_files()
{
  if (fs::exists("/dev/full")) {
    CHECK_THROWS(Output_error, write("/dev/full"), "/dev/full: cannot write: No space left on device");
    CHECK_THROWS(Output_error, write("/dev/full", std::string(100000, 'x')), "No space left on device");
    CHECK(fs::is_character_file("/dev/full"));
  }
  write("/dev/null");
  CHECK(fs::is_character_file("/dev/null"));

  const Temporary_folder folder;
  const std::string pipe = folder.path("pipe");
  CHECK(mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  write(pipe);
  std::string received(1000, '\0');
  const ssize_t n = read(reader, &received[0], received.size());
  received.resize(n > 0 ? std::size_t(n) : 0);
  CHECK(received == text);
  CHECK(fs::is_fifo(pipe) && folder.number_of_entries() == 1);

  std::signal(SIGPIPE, SIG_IGN);
  IO::Output_file file(pipe);
  close(reader);
  file.stream() << text;
  CHECK_THROWS(Output_error, file.commit(), pipe + ": cannot write: Broken pipe");
}

// Standard output as a file to which somebody has written before and will write again.
void test_standard_output()
{
  const Temporary_folder folder;
  folder.write("out", "before\n");
  std::cout.flush();
  std::fflush(stdout);
  const int terminal = dup(1);
  const int out = open(folder.path("out").c_str(), O_WRONLY | O_APPEND);
  dup2(out, 1);
  write("-", "one\n");
  std::cout << "between\n" << std::flush;
  write("/dev/stdout", "two\n");
  {
    IO::Output_file file("-");
    CHECK(file.name() == "standard output");
    file.commit();
  }
  write("/dev/fd/" + std::to_string(out), "three\n");
  std::string message;
  const int full = open("/dev/full", O_WRONLY);
  if (full >= 0) {
    dup2(full, 1);
    try {
      write("-", "lost\n");
    } catch (const Output_error& e) {
      message = e.what();
    }
    dup2(out, 1); // takes what the C library has kept
    std::clearerr(stdout);
    std::fflush(stdout);
    close(full);
  }
  dup2(terminal, 1);
  close(out);
  close(terminal);
  const std::string expected = "before\none\nbetween\ntwo\nthree\n";
  CHECK(folder.read("out").substr(0, expected.size()) == expected);
  if (full >= 0) CHECK(message == "standard output: cannot write: No space left on device");
  CHECK(folder.number_of_entries() == 1);
}

#endif // __unix__

} // namespace

int main()
{
  use_hostile_locale();
  std::setlocale(LC_ALL, "C"); // the system's messages in English
  test_new_and_old_files();
  test_exception_midway();
  test_errors();
#ifdef __unix__
  test_permissions();
  test_links();
  test_leftovers();
  test_killed_writer();
  test_full_disk();
  test_special_files();
  test_standard_output();
#endif
  return test_result();
}
