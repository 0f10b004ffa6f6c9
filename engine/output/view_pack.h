#pragma once
// Numbers as text in a page: float32 or int32, their bytes sorted by weight, zlib, base64. The script that takes them
// back is view/data.js.
#include <string>
#include <vector>

namespace talus {

// With 3 bytes a number keeps 12 bits behind its leading one, 1.2e-4 of its value; with 4 all of float32.
std::string packed_floats(const std::vector<float>& values, int bytes);
std::string packed_whole(const std::vector<int>& values);
std::string base64(const std::string& bytes);

}  // namespace talus
