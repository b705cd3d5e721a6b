#include "volume/vdb/vdb_decoder.h"

// ISOLOOP_VDB_DECODER: path of the executable, known to the build alone.
asm(R"(
  .pushsection .rodata
  .balign 16
  .global isoloop_vdb_decoder_begin
  .global isoloop_vdb_decoder_end
isoloop_vdb_decoder_begin:
  .incbin ")" ISOLOOP_VDB_DECODER R"("
isoloop_vdb_decoder_end:
  .byte 0
  .popsection
)");

extern "C" const char isoloop_vdb_decoder_begin[];
extern "C" const char isoloop_vdb_decoder_end[];

namespace isoloop {

std::span<const char> vdb_decoder_program() {
  return {isoloop_vdb_decoder_begin, isoloop_vdb_decoder_end};
}

}  // namespace isoloop
