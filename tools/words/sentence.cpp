#include "tools/words/sentence.h"

#include <algorithm>

namespace isoloop {
namespace {

std::string part_text(std::string_view command) {
  if (command == "generate") return "take a smaller --size";
  // A repaired part would be no copy of its file.
  return command == "repair" ? "crop the volume" : "read a part of the volume (--crop)";
}

std::string words_of(Advice advice, std::string_view command) {
  switch (advice) {
    case Advice::raise_memory_limit:
      return "raise --max-memory";
    case Advice::raise_voxel_limit:
      return "raise --max-voxels";
    case Advice::take_part:
      return part_text(command);
    case Advice::take_smaller_volume:
      return command == "generate" ? "take a smaller --size" : "take a smaller volume";
    case Advice::take_smaller_mesh:
      return "take a smaller mesh";
    case Advice::take_larger_voxels:
      return "take larger voxels (--voxel)";
    case Advice::halve_resolution:
      return "halve its resolution";
    case Advice::correct_header:
      return "correct the header";
    case Advice::check_raw_layout:
      return "check --dims, --type and --skip, or fetch the file again";
    case Advice::name_raw_file:
      return "name the file NAME_256x256x128_uint8.raw";
    case Advice::state_dims:
      return "give --dims (and --type)";
    case Advice::state_voxel_type:
      return "give --type";
    case Advice::state_spacing:
      return "give --spacing X Y Z";
    case Advice::override_spacing:
      return "--spacing X Y Z says otherwise";
    case Advice::resample:
      return "resample it to right angles";
    case Advice::state_voxel_size:
      return "give --voxel LENGTH or --resolution VOXELS (or auto)";
    case Advice::replace_nan:
      return "say with --nan-as VALUE what NaN stands for";
    case Advice::choose_grid:
      return "choose one with --grid NAME";
    case Advice::choose_frame:
      return "choose with --frame N";
    case Advice::choose_channel:
      return "choose with --channel N";
    case Advice::choose_frame_and_channel:
      return "choose with --channel N and --frame N";
    case Advice::choose_series:
      return "choose one with --series TEXT";
    case Advice::choose_sform:
      return "take the sform with --affine sform";
    case Advice::choose_qform:
      return "take the qform with --affine qform";
    case Advice::unpack_slices:
      return "unpack them with: gdcmconv --raw IN OUT";
    case Advice::check_dims:
      return "check the dimensions, for which no --max-memory is enough";
  }
  return "";
}

}  // namespace

std::string one_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string flag_of(Option option) {
  switch (option) {
    case Option::iso:
      return "--iso";
    case Option::boundary:
      return "--open-boundary";
    case Option::loops:
      return "--ids";
    case Option::spacing:
      return "--spacing";
    case Option::dims:
      return "--dims";
    case Option::voxel_type:
      return "--type";
    case Option::grid:
      return "--grid";
    case Option::frame:
      return "--frame";
    case Option::channel:
      return "--channel";
    case Option::series:
      return "--series";
    case Option::transform:
      return "--affine";
    case Option::labels:
      return "--label";
    case Option::crop:
      return "--crop";
    case Option::world:
      return "--world";
    case Option::voxel_size:
      return "--voxel or --resolution";
    case Option::automatic_resolution:
      return "--resolution auto";
    case Option::nan_value:
      return "--nan-as";
    case Option::shape:
    case Option::none:
      return "";
  }
  return "";
}

std::string advice_text(const std::vector<Advice>& advice, std::string_view command) {
  std::vector<std::string> ways;
  for (const Advice way : advice) {
    const std::string words = words_of(way, command);
    if (std::find(ways.begin(), ways.end(), words) == ways.end()) ways.push_back(words);
  }
  std::string text;
  for (const std::string& way : ways) text += (text.empty() ? "" : " or ") + way;
  return text;
}

std::string sentence_of(const Finding& finding, std::string_view command, Option option) {
  Finding in_flags = finding;
  const std::string subject = flag_of(finding.about);
  if (!subject.empty()) {
    in_flags.text = subject + " " + finding.text;
    in_flags.about = Option::none;
  }
  std::string text = one_line(text_of(in_flags));
  const std::string advice = advice_text(finding.advice, command);
  if (!advice.empty()) return text + "; " + advice;
  const std::string flag = flag_of(option);
  return flag.empty() || !subject.empty() ? text : text + " (" + flag + ")";
}

std::vector<std::string> sentences_of(const std::vector<Finding>& findings) {
  std::vector<std::string> sentences;
  sentences.reserve(findings.size());
  for (const Finding& finding : findings) sentences.push_back(sentence_of(finding));
  return sentences;
}

}  // namespace isoloop
