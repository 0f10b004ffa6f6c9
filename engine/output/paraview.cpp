#include "output/paraview.h"

#include <algorithm>
#include <filesystem>

#include "output/text.h"
#include "output/view_parts.h"

namespace talus {
namespace {

void replace(std::string& text, const std::string& mark, const std::string& value) {
  text.replace(text.find(mark), mark.size(), value);
}

}  // namespace

std::string paraview_state(const Output& output) {
  std::string folder = std::filesystem::absolute(output.dir).lexically_normal().string();
  // would end the text; files beside it are found all the same
  std::erase_if(folder, [](char c) { return c == '"' || c == '\n'; });
  while (folder.ends_with('/') || folder.ends_with('\\')) folder.pop_back();
  std::string text = view_parts::paraview;
  replace(text, "@FOLDER@", folder);
  replace(text, "@FIELD@", output.picture_field);
  replace(text, "@SCALE@", shortest(std::max(output.picture_scale, 1.0)));
  return text;
}

}  // namespace talus
