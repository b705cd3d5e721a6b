#include "core/base/finding.h"

namespace isoloop {

std::string name_of(Option option) {
  switch (option) {
    case Option::none:
      return "";
    case Option::iso:
      return "the iso value";
    case Option::boundary:
      return "the boundary";
    case Option::loops:
      return "the number of the loop";
    case Option::spacing:
      return "the spacing";
    case Option::dims:
      return "the dimensions";
    case Option::voxel_type:
      return "the voxel type";
    case Option::grid:
      return "the grid";
    case Option::frame:
      return "the frame";
    case Option::channel:
      return "the channel";
    case Option::series:
      return "the series";
    case Option::transform:
      return "the transform";
    case Option::labels:
      return "the labels";
    case Option::crop:
      return "the crop";
    case Option::world:
      return "the frame of the world";
    case Option::voxel_size:
      return "the size of the voxels";
    case Option::automatic_resolution:
      return "automatic resolution";
    case Option::nan_value:
      return "the value for NaN";
    case Option::shape:
      return "the shape";
  }
  return "";
}

std::string text_of(const Finding& finding) {
  std::string text = finding.file;
  const auto add = [&](const std::string& part, const char* separator) {
    if (!part.empty()) text += (text.empty() ? "" : separator) + part;
  };
  add(finding.place, ": ");
  const std::string subject = name_of(finding.about);
  add(subject.empty() ? finding.text : subject + " " + finding.text, ": ");
  return text;
}

}  // namespace isoloop
