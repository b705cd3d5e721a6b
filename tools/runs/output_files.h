// The reports that a command writes to files: all of them, or none.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace isoloop {

/// Holds the names of the files from before the work starts, so that a name that cannot be written
/// costs no time. Nothing is left on disk between add() and write().
class OutputFiles {
 public:
  using Report = std::function<void(std::ostream&)>;

  /// `input` is never overwritten; empty: there is none.
  explicit OutputFiles(std::filesystem::path input) : input_(std::move(input)) {}

  /// Asks for `report` in the file `name`; on standard output for "-"; nowhere for "". `flag` opens
  /// the message of an error. Throws InvalidArgument where the name is a flag, or the file is the
  /// input, a file in the input's folder, or has been asked for before, InvalidInput where it
  /// cannot be created.
  void add(const std::string& flag, const std::string& name, const Report& report);

  /// Holds the file `name` for what is written otherwise: the same checks as add(). `name` must be
  /// that of a file.
  void reserve(const std::string& flag, const std::string& name);

  /// Throws InvalidArgument if an output is this file, which was read beside the input; empty:
  /// there was none.
  void check_apart_from(const std::filesystem::path& data_file) const;

  /// True if a report goes to standard output.
  bool uses_stdout() const;

  /// Writes all reports. Throws InvalidInput if one could not be written, LimitExceeded where the
  /// disk is full.
  void write() const;

 private:
  void write_all() const;

  struct Output {
    std::string flag;
    std::string name;
    Report report;
  };

  std::filesystem::path input_;
  std::vector<Output> outputs_;
};

/// `write`, of a run that is there only once the reports are written. `run` must outlive it.
template <class Result, class Write>
OutputFiles::Report report_of(const Result& run, Write write) {
  return [&run, write = std::move(write)](std::ostream& out) { write(out, run); };
}

/// Throws InvalidInput, naming the file, if it cannot be created or replaced. Changes nothing.
void check_writable(const std::filesystem::path& path);

/// Throws InvalidInput if standard output could not take all that was written to it, LimitExceeded
/// if it leads to a full disk.
void finish_stdout();

}  // namespace isoloop
