#pragma once
// Frames for ParaView: .vtp files (polydata), raw appended and LZ4. The only room that knows VTK.
#include <string>
#include <vector>

#include "model/fields.h"
#include "output/user_arrays.h"

namespace talus {

class Gas;

// Blocks as polygons; each has its own points, so that neighbours can move apart. Smoothed stresses are left
// out where the context has no recovery. Throws RunError when the file cannot be written.
void write_blocks_vtp(const std::string& path, const FieldContext& context, const std::vector<UserArray>& arrays);

// Joints and contacts as lines. A contact is drawn as the part of the edge it stands for: the line from the
// vertex to the edge would be too short to see as soon as they touch.
void write_joints_vtp(const std::string& path, const Model& model);

// Failed and real joints as lines between where their ends are now; where there is gas also how far it has come in
// each, and its pressure there.
void write_cracks_vtp(const std::string& path, const Model& model, const Gas* gas = nullptr);

std::string vtk_version();

}  // namespace talus
