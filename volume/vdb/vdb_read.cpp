#include <algorithm>
#include <istream>
#include <string>
#include <system_error>

#include "core/base/errors.h"
#include "volume/base/child_process.h"
#include "volume/base/memory_limit.h"
#include "volume/base/refuse.h"
#include "volume/vdb/vdb.h"
#include "volume/vdb/vdb_decoder.h"
#include "volume/vdb/vdb_message.h"

namespace isoloop {
namespace {

// Nodes of an OpenVDB tree are stored with two bit masks of their size, which no codec compresses:
// a leaf of 8^3 doubles takes 4.2 kB in memory and 128 bytes or more in the file, a node above
// leaves 33 kB and 1 kB. Vectors of doubles, which are read too where the file holds them, take
// three times as much.
constexpr std::uint64_t most_expansion = 128;
constexpr std::uint64_t base_memory = std::uint64_t{64} << 20;  // of the program itself, and codecs

std::uint64_t file_bytes(const std::filesystem::path& path) {
  std::error_code error;
  const std::uint64_t bytes = std::filesystem::file_size(path, error);
  if (error)
    throw InvalidInput({.file = path.string(), .text = "cannot be read: " + error.message()},
                       Fault::unreadable);
  return bytes;
}

/// Memory of whole files stays below: a file that asks for more is damaged.
std::uint64_t most_memory(std::uint64_t bytes) {
  constexpr std::uint64_t huge = std::uint64_t{1} << 50;
  return base_memory + most_expansion * std::min(bytes, huge);
}

[[noreturn]] void throw_reason(const std::filesystem::path& path, const ChildEnd& end,
                               std::uint64_t callers_limit, bool limited_by_caller,
                               const std::string& broken) {
  using How = ChildEnd::How;
  const std::string file = path.string();
  const std::string damaged = "not a whole OpenVDB file; fetch or export it again";
  const bool out_of_memory =
      end.how == How::exited && end.number == static_cast<int>(DecoderStatus::out_of_memory);
  if (limited_by_caller && (out_of_memory || end.how == How::crashed)) {
    throw LimitExceeded({.file = path.string(),
                         .text = "its grids need more memory than the limit, or the file "
                                 "is damaged",
                         .advice = {Advice::raise_memory_limit, Advice::take_smaller_volume}},
                        {.unit = Excess::Unit::bytes, .limit = callers_limit, .stage = "read"});
  }
  if (out_of_memory) {
    refuse(file, damaged + " (it asks for more memory than a file of its size needs)");
  }
  switch (end.how) {
    case How::crashed:
      refuse(file,
             damaged + " (OpenVDB broke down over it, signal " + std::to_string(end.number) + ")");
    case How::out_of_time:
      refuse(file, damaged + " (it takes longer than a file of its size needs)");
    case How::interrupted:
      throw InvalidInput({.file = path.string(), .text = "reading was interrupted"},
                         Fault::unreadable);
    default:
      refuse(file, damaged + " (of what OpenVDB made of it, " + broken + ")");
  }
}

ChildProcess start_decoder(const std::filesystem::path& path, const ChildLimits& limits,
                           const std::vector<std::string>& arguments) {
  try {
    return ChildProcess(vdb_decoder_program(), limits, arguments);
  } catch (const std::system_error& error) {
    throw InvalidInput(
        {.file = path.string(),
         .text =
             std::string("the program that decodes .vdb files cannot be started: ") + error.what()},
        Fault::unreadable);
  }
}

}  // namespace

Volume read_vdb(const std::filesystem::path& path, const std::string& grid,
                const VoxelLimits& limits, VdbMargin margin) {
  const std::uint64_t bytes = file_bytes(path);
  const std::uint64_t callers_limit =
      limits.max_bytes == 0 ? default_voxel_limit() : limits.max_bytes;
  const std::uint64_t memory = most_memory(bytes);
  const bool limited_by_caller = callers_limit < memory - base_memory;
  const ChildLimits child_limits{
      .memory_bytes = limited_by_caller ? callers_limit + base_memory : memory,
      .cpu_seconds = 1 + (bytes >> 20)};
  ChildProcess child = start_decoder(
      path, child_limits, {path.string(), grid, margin == VdbMargin::background ? "1" : "0"});
  try {
    return receive_volume(child.output(), limits, path.string());
  } catch (const BrokenMessage& error) {
    throw_reason(path, child.wait(), callers_limit, limited_by_caller, error.what());
  }
}

}  // namespace isoloop
