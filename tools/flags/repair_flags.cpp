#include "tools/flags/repair_flags.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "tools/flags/length_flag.h"
#include "tools/words/flag_checks.h"

namespace isoloop {
namespace {

double length_of(const std::string& typed, const char* flag, const Volume* volume) {
  if (typed.empty()) return 0.0;
  const TypedLength length = parse_length(flag, typed);
  if (!(length.value > 0.0)) throw InvalidArgument(std::string(flag) + " wants a positive length");
  return volume == nullptr ? length.value : length_in(length, *volume, flag);
}

LoopName loop_name(std::string_view word, const std::string& side) {
  const std::string whole(word);
  const std::string wanted = "write h3,t7 for handle 3 and tunnel 7";
  if (word.empty()) throw InvalidArgument("--ids: an id is missing beside a comma; " + wanted);
  LoopName name;
  if (word.starts_with('h') || word.starts_with('t')) {
    name.kind = word[0] == 'h' ? LoopKind::handle : LoopKind::tunnel;
    word.remove_prefix(1);
  } else if (side.empty()) {
    throw InvalidArgument("--ids " + whole + ": handles and tunnels are numbered apart; write h" +
                          whole + " or t" + whole + ", or add --side handle or --side tunnel");
  } else {
    name.kind = side == "handle" ? LoopKind::handle : LoopKind::tunnel;
  }
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), name.id);
  if (error != std::errc() || end != word.data() + word.size() || name.id < 1) {
    throw InvalidArgument("--ids: '" + whole + "' is no id; " + wanted);
  }
  return name;
}

}  // namespace

void add_repair_flags(CLI::App& command, RepairFlags& flags) {
  command
      .add_option(
          "--fill-tunnels", flags.fill_tunnels,
          "fill every tunnel whose loop is shorter than this, in the unit of the spacing or "
          "with one (3mm)")
      ->type_name("SIZE");
  command
      .add_option("--cut-handles", flags.cut_handles,
                  "cut every handle whose loop is shorter than this")
      ->type_name("SIZE");
  command
      .add_option("--auto", flags.either,
                  "remove every handle and tunnel whose loop is shorter than this by a cut or a "
                  "fill, whichever changes fewer voxels")
      ->type_name("SIZE");
  command
      .add_option("--ids", flags.ids,
                  "remove these loops of `isoloop loops`, such as h3,t7; 3,7 with --side")
      ->type_name("LIST");
  command.add_option("--side", flags.side, "what numbers without h or t mean in --ids")
      ->check(CLI::IsMember({"handle", "tunnel"}))
      ->type_name("KIND");
  want_whole_number(
      command
          .add_option("--genus", flags.genus,
                      "remove the shortest loops until the surface has this genus or less")
          ->type_name("N"),
      0);
  command.add_flag("--keep-going", flags.keep_going,
                   "list the loops that cannot be removed, and remove the others");
  for (const char* flag : {"--fill-tunnels", "--cut-handles", "--auto"})
    want_text(command.get_option(flag));
}

RepairRequest repair_request(const RepairFlags& flags, const Volume* volume) {
  if (flags.fill_tunnels.empty() && flags.cut_handles.empty() && flags.either.empty() &&
      !flags.genus && flags.ids.empty()) {
    throw InvalidArgument(
        "nothing to repair is named: give --fill-tunnels, --cut-handles, --auto, --ids or --genus");
  }
  RepairRequest request;
  request.fill_tunnels = length_of(flags.fill_tunnels, "--fill-tunnels", volume);
  request.cut_handles = length_of(flags.cut_handles, "--cut-handles", volume);
  request.either = length_of(flags.either, "--auto", volume);
  request.genus = flags.genus;
  request.keep_going = flags.keep_going;
  const std::string_view ids = flags.ids;
  for (std::size_t at = 0; !ids.empty() && at <= ids.size();) {
    const std::size_t comma = std::min(ids.find(',', at), ids.size());
    request.loops.push_back(loop_name(ids.substr(at, comma - at), flags.side));
    at = comma + 1;
  }
  return request;
}

}  // namespace isoloop
