# Writes a C++ file that holds the viewer's files.
#   cmake -DFOLDER=tools/viewer -DOUTPUT=viewer_files.cpp -P embed.cmake
# Compilers need not take more than 65536 characters in one literal: hence pieces.
set(piece_length 60000)

function(pieces_of file result)
  file(READ "${file}" content)
  string(LENGTH "${content}" length)
  set(pieces "")
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${content}" ${at} ${piece_length} piece)
    string(APPEND pieces "    R\"isoloop(${piece})isoloop\",\n")
    math(EXPR at "${at} + ${piece_length}")
  endwhile()
  set(${result} "${pieces}" PARENT_SCOPE)
endfunction()

pieces_of("${FOLDER}/page.html" page)
pieces_of("${FOLDER}/viewer.min.js" script)
file(WRITE "${OUTPUT}" "#include \"tools/page/viewer_files.h\"

namespace isoloop {
namespace {

const std::string_view page[] = {
${page}};

const std::string_view script[] = {
${script}};

}  // namespace

std::span<const std::string_view> viewer_page() { return page; }

std::span<const std::string_view> viewer_script() { return script; }

}  // namespace isoloop
")
