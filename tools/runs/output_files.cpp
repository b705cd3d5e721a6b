#include "tools/runs/output_files.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iostream>
#include <memory>
#include <system_error>

#include <unistd.h>

#include "core/base/errors.h"
#include "core/base/stage.h"
#include "volume/base/atomic_file.h"

namespace isoloop {
namespace {

bool is_stdout(const std::string& name) { return name == "-"; }

/// What is written there is gone.
bool is_null_device(const std::string& name) {
  std::error_code ignored;
  return std::filesystem::weakly_canonical(name, ignored) == "/dev/null";
}

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  const auto absolute = [&error](const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path), error);
  };
  return std::filesystem::equivalent(a, b, error) || absolute(a) == absolute(b);
}

bool is_in_folder(const std::filesystem::path& file, const std::filesystem::path& folder) {
  std::error_code ignored;
  return std::filesystem::is_directory(folder, ignored) &&
         same_file(std::filesystem::absolute(file).parent_path(), folder);
}

std::string clash(const std::string& flag, const std::string& name, const char* what) {
  std::string sentence = flag;
  sentence.append(" ").append(name).append(" would overwrite ").append(what);
  return sentence;
}

}  // namespace

void OutputFiles::add(const std::string& flag, const std::string& name, const Report& report) {
  if (name.empty()) return;
  if (name.starts_with("--")) throw InvalidArgument(flag + " wants a file name after it");
  for (const Output& other : outputs_) {
    const bool both_stdout = is_stdout(name) && is_stdout(other.name);
    const bool both_files = !is_stdout(name) && !is_stdout(other.name) && !is_null_device(name);
    if (both_stdout || (both_files && same_file(name, other.name))) {
      throw InvalidArgument(clash(flag, name, "another output"));
    }
  }
  if (!is_stdout(name) && !is_null_device(name)) {
    if (!input_.empty() && same_file(name, input_)) {
      throw InvalidArgument(clash(flag, name, "the input"));
    }
    if (std::filesystem::exists(name) && is_in_folder(name, input_)) {
      throw InvalidArgument(clash(flag, name, "a file of the folder that is read"));
    }
    check_writable(name);
  }
  outputs_.push_back({flag, name, report});
}

void OutputFiles::reserve(const std::string& flag, const std::string& name) {
  if (is_stdout(name)) throw InvalidArgument(flag + " wants a file, not standard output");
  add(flag, name, {});
}

void OutputFiles::check_apart_from(const std::filesystem::path& data_file) const {
  if (data_file.empty()) return;
  for (const Output& output : outputs_)
    if (!is_stdout(output.name) && same_file(output.name, data_file))
      throw InvalidArgument(clash(output.flag, output.name, "the input's file of voxels"));
}

bool OutputFiles::uses_stdout() const {
  return std::any_of(outputs_.begin(), outputs_.end(),
                     [](const Output& output) { return is_stdout(output.name); });
}

void OutputFiles::write() const {
  in_stage("report", [&] { write_all(); });
}

void OutputFiles::write_all() const {
  std::vector<std::unique_ptr<AtomicFile>> files;
  for (const Output& output : outputs_) {
    if (is_stdout(output.name) || !output.report) continue;
    if (is_null_device(output.name)) {
      std::ofstream nowhere("/dev/null", std::ios::binary);
      output.report(nowhere);
      continue;
    }
    files.push_back(std::make_unique<AtomicFile>(output.name));
    output.report(files.back()->stream());
  }
  for (const auto& file : files) file->commit();
  for (const Output& output : outputs_) {
    if (is_stdout(output.name)) output.report(std::cout);
  }
}

void check_writable(const std::filesystem::path& path) { const AtomicFile probe(path); }

void finish_stdout() {
  std::cout.flush();
  if (std::cout) return;
  // The stream does not keep the reason that it failed for: one more byte meets it again.
  const bool full = write(STDOUT_FILENO, "\n", 1) != 1 && is_out_of_room(errno);
  if (full) throw LimitExceeded("standard output cannot be written: no room; the disk may be full");
  throw InvalidInput("standard output cannot be written");
}

}  // namespace isoloop
