// The program that read_vdb() starts for each file: it decodes the file, sends the voxels and ends.
// Arguments after those of limit_this_process(): the file, the grid's name, the margin.
#include "volume/vdb/vdb_decoder.h"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <new>

#include <tbb/global_control.h>

#include "core/base/errors.h"
#include "volume/base/child_process.h"
#include "volume/vdb/vdb_decode.h"
#include "volume/vdb/vdb_message.h"

namespace isoloop {
namespace {

DecoderStatus decode(const std::vector<std::string>& arguments) {
  if (arguments.size() != 3) return DecoderStatus::failed;
  try {
    std::ifstream file(arguments[0], std::ios::binary);
    if (!file)
      throw InvalidInput(
          {.file = arguments[0], .text = "cannot be opened; check that you may read it"},
          Fault::unreadable);
    const VdbRequest request{arguments[1],
                             arguments[2] == "1" ? VdbMargin::background : VdbMargin::none};
    decode_vdb(file, request, arguments[0], std::cout);
  } catch (const InvalidArgument& error) {
    send_error(std::cout, error);
  } catch (const InvalidInput& error) {
    send_error(std::cout, error);
  }
  return std::cout.flush() ? DecoderStatus::done : DecoderStatus::failed;
}

}  // namespace
}  // namespace isoloop

int main(int argc, char** argv) {
  using isoloop::DecoderStatus;
  auto status = DecoderStatus::failed;
  try {
    const std::vector<std::string> arguments = isoloop::limit_this_process(argc, argv);
    // Threads would need stacks within the limit.
    const tbb::global_control serial(tbb::global_control::max_allowed_parallelism, 1);
    std::ios::sync_with_stdio(false);
    status = isoloop::decode(arguments);
  } catch (const std::bad_alloc&) {
    status = DecoderStatus::out_of_memory;
  } catch (...) {
  }
  std::_Exit(static_cast<int>(status));  // the system frees faster than destructors do
}
