#pragma once
// The files of output/view, in the program.
namespace talus::view_parts {

extern const char *const page, *const style, *const script, *const paraview;

}  // namespace talus::view_parts
