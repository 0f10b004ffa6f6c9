#include <gtest/gtest.h>
#include <unistd.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "equations/recovery.h"
#include "gas/eos.h"
#include "gas/gas.h"
#include "hand_model.h"
#include "output/pvd.h"
#include "output/vtk_writer.h"
#include "scene/error.h"
#include "small_scene.h"
#include "step/simulation.h"

namespace talus {
namespace {

using test::moved_squares;
using test::two_squares;

std::string scratch_vtk(const std::string& name) {
  const auto dir = std::filesystem::temp_directory_path() / ("talus_test_vtk_" + std::to_string(getpid()));
  std::filesystem::create_directories(dir);
  return (dir / name).string();
}

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

vtkSmartPointer<vtkPolyData> read(const std::string& path) {
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), 0u);
  return reader->GetOutput();
}

double cell(vtkPolyData* data, const char* name, int id, int component = 0) {
  vtkDataArray* array = data->GetCellData()->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  return array ? array->GetComponent(id, component) : NAN;
}

std::string name(vtkPolyData* data, const char* array, int id) {
  auto* names = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(array));
  EXPECT_NE(names, nullptr) << array;
  return names ? names->GetValue(id) : std::string();
}

TEST(VtkBlocks, ReadBackAsPolygonsInUserCoordinates) {
  const Model model = moved_squares();
  write_blocks_vtp(scratch_vtk("blocks.vtp"), {model, nullptr}, {});
  const auto data = read(scratch_vtk("blocks.vtp"));
  ASSERT_EQ(data->GetNumberOfPolys(), 2);
  ASSERT_EQ(data->GetNumberOfPoints(), 8);
  EXPECT_EQ(data->GetCell(1)->GetNumberOfPoints(), 4);
  EXPECT_EQ(data->GetCell(1)->GetPointId(2), 6);
  for (int v = 0; v < 8; ++v) {
    EXPECT_EQ(data->GetPoint(v)[0], model.vertex[v].x() + 100);
    EXPECT_EQ(data->GetPoint(v)[1], model.vertex[v].y() + 50);
    EXPECT_EQ(data->GetPoint(v)[2], 0);
  }
}

TEST(VtkBlocks, ArraysHoldTheFields) {
  const Model model = moved_squares();
  write_blocks_vtp(scratch_vtk("blocks.vtp"), {model, nullptr}, {{"heat", {7.5, -2}}});
  const auto data = read(scratch_vtk("blocks.vtp"));
  EXPECT_EQ(cell(data, "id", 0), 1);  // as sim.blocks[1] of Lua
  EXPECT_EQ(cell(data, "id", 1), 2);
  EXPECT_EQ(cell(data, "region", 1), 1);
  EXPECT_EQ(cell(data, "fixed", 1), 1);
  EXPECT_EQ(cell(data, "velocity", 0, 1), 4);
  EXPECT_EQ(data->GetCellData()->GetArray("velocity")->GetNumberOfComponents(), 3);
  EXPECT_NEAR(cell(data, "displacement", 0, 0), 0.1, 1e-15);
  EXPECT_DOUBLE_EQ(cell(data, "rotation", 0), std::acos(0.0));
  EXPECT_NEAR(cell(data, "strain", 0, 1), 0.001, 1e-15);
  EXPECT_STREQ(data->GetCellData()->GetArray("strain")->GetComponentName(2), "gxy");
  EXPECT_EQ(cell(data, "sxx", 0), model.stress(0)[0]);
  EXPECT_EQ(cell(data, "s1", 0), principals(model.stress(0)).first);
  EXPECT_EQ(cell(data, "heat", 0), 7.5);
  EXPECT_EQ(cell(data, "heat", 1), -2);
  EXPECT_EQ(data->GetCellData()->GetArray("id")->GetDataType(), VTK_INT);
  EXPECT_EQ(data->GetCellData()->GetArray("sxx_smooth"), nullptr);  // there is no recovery
  EXPECT_NEAR(data->GetPointData()->GetArray("displacement")->GetComponent(2, 1), 0.7 + 0.5006 - 1, 1e-12);
}

TEST(VtkBlocks, SmoothedStressesOfTheRecovery) {
  const Model model = moved_squares();
  const Recovery recovery(model);
  const std::vector<Vec3> smoothed = {{3, -1, 2}, {7, 8, 0}};
  write_blocks_vtp(scratch_vtk("blocks.vtp"), {model, &recovery, &smoothed}, {});
  const auto data = read(scratch_vtk("blocks.vtp"));
  EXPECT_EQ(cell(data, "sxy_smooth", 0), 2);
  EXPECT_EQ(cell(data, "syy_smooth", 1), 8);
  EXPECT_DOUBLE_EQ(cell(data, "s1_smooth", 0), 1 + std::sqrt(8.0));
  EXPECT_DOUBLE_EQ(cell(data, "s2_smooth", 0), 1 - std::sqrt(8.0));
  EXPECT_EQ(cell(data, "sxx", 0), model.stress(0)[0]);
}

TEST(VtkBlocks, NamesAndTime) {
  Model model = two_squares();
  model.time = 0.125;
  write_blocks_vtp(scratch_vtk("blocks.vtp"), {model, nullptr}, {});
  const auto data = read(scratch_vtk("blocks.vtp"));
  EXPECT_EQ(name(data, "region_names", 1), "right");
  EXPECT_EQ(name(data, "material_names", 0), "rock");
  EXPECT_EQ(data->GetFieldData()->GetArray("TimeValue")->GetTuple1(0), 0.125);
}

TEST(VtkBlocks, RawAppendedLz4) {
  write_blocks_vtp(scratch_vtk("blocks.vtp"), {two_squares(), nullptr}, {});
  const std::string file = text_of(scratch_vtk("blocks.vtp"));
  EXPECT_NE(file.find("compressor=\"vtkLZ4DataCompressor\""), std::string::npos);
  EXPECT_NE(file.find("<AppendedData encoding=\"raw\">"), std::string::npos);
}

TEST(VtkBlocks, PlaceThatCannotBeWrittenIsARunError) {
  EXPECT_THROW(write_blocks_vtp(scratch_vtk("no/such/dir.vtp"), {two_squares(), nullptr}, {}), RunError);
}

TEST(VtkJoints, JointAndContactAsLines) {
  Model model = two_squares();
  model.joints[0].state = JointState::failed;
  model.blocks[1].centroid += Vec2(0.2, 0);
  model.place_vertices();
  write_joints_vtp(scratch_vtk("joints.vtp"), model);
  const auto data = read(scratch_vtk("joints.vtp"));
  ASSERT_EQ(data->GetNumberOfLines(), 2);
  EXPECT_EQ(cell(data, "kind", 0), 0);
  EXPECT_EQ(cell(data, "kind", 1), 1);
  for (int line : {0, 1}) {  // the first joint and the first contact, both of blocks 1 and 2
    EXPECT_EQ(cell(data, "id", line), 1);
    EXPECT_EQ(cell(data, "block_a", line), 1);
    EXPECT_EQ(cell(data, "block_b", line), 2);
  }
  EXPECT_EQ(name(data, "state_names", static_cast<int>(cell(data, "state", 0))), "failed");
  EXPECT_EQ(name(data, "state_names", static_cast<int>(cell(data, "state", 1))), "slip");
  EXPECT_EQ(name(data, "property_names", static_cast<int>(cell(data, "property", 1))), "bond <1>");
  EXPECT_DOUBLE_EQ(cell(data, "normal_traction", 0), 500);
  EXPECT_DOUBLE_EQ(cell(data, "normal_traction", 1), -2000);
  EXPECT_DOUBLE_EQ(cell(data, "shear_traction", 1), 500);
  EXPECT_DOUBLE_EQ(cell(data, "opening", 0), 0.005);
  EXPECT_DOUBLE_EQ(cell(data, "opening", 1), -1e-4);
  EXPECT_DOUBLE_EQ(cell(data, "slip", 1), 3e-3);
  // The joint runs half-way between the two sides.
  EXPECT_NEAR(data->GetPoint(0)[0], 101.1, 1e-12);
  EXPECT_NEAR(data->GetPoint(1)[1], 51, 1e-12);
}

TEST(VtkJoints, ContactIsThePartOfTheEdgeItStandsFor) {
  Model model = two_squares();
  write_joints_vtp(scratch_vtk("joints.vtp"), model);
  auto data = read(scratch_vtk("joints.vtp"));
  // From its corner at the lower end half way up the side that both blocks share.
  EXPECT_NEAR(data->GetPoint(2)[0], 101, 1e-12);
  EXPECT_NEAR(data->GetPoint(2)[1], 50, 1e-12);
  EXPECT_NEAR(data->GetPoint(3)[1], 50.5, 1e-12);
  // Block 0 lower by 0.4: its corner rests beyond the edge's end, and half of the common 0.6 m is drawn.
  model.blocks[0].centroid.y() -= 0.4;
  model.place_vertices();
  write_joints_vtp(scratch_vtk("joints.vtp"), model);
  data = read(scratch_vtk("joints.vtp"));
  EXPECT_NEAR(data->GetPoint(2)[1], 50, 1e-12);
  EXPECT_NEAR(data->GetPoint(3)[1], 50.3, 1e-12);
}

TEST(VtkJoints, ContactWithoutLengthIsSeen) {
  for (const double turn : {0.0, 0.3}) {  // of one kind by name, or by what it has become
    Model model = two_squares();
    if (turn == 0) model.contacts[0].kind = ContactKind::angle_edge;
    model.blocks[0].angle = turn;
    model.place_vertices();
    write_joints_vtp(scratch_vtk("joints.vtp"), model);
    const auto data = read(scratch_vtk("joints.vtp"));
    const double low = data->GetPoint(3)[1], high = data->GetPoint(2)[1];
    EXPECT_NEAR(std::abs(high - low), 0.02, 1e-12);
    EXPECT_GE(std::min(low, high), 50);
    EXPECT_LE(std::max(low, high), 51);
  }
}

// The two contacts of a block on a longer one: together they are drawn from corner to corner.
TEST(VtkJoints, ContactsOfAFaceCoverIt) {
  Model model;
  model.scene = two_squares().scene;
  test::add_block(model, test::rectangle(2, 1, 10, 1), 6, 0);
  test::add_block(model, test::rectangle(0, 0, 20, 1), 0, 1);
  model.place_vertices();
  Contact contact = two_squares().contacts[0];
  for (const int vertex : {0, 1}) {  // of the lower side; edge 2 of block 1 runs from (20, 1) to (0, 1)
    contact.vertex = contact.global_vertex = vertex;
    contact.edge = 2;
    contact.global_edge = 6;
    model.contacts.push_back(contact);
  }
  write_joints_vtp(scratch_vtk("joints.vtp"), model);
  const auto data = read(scratch_vtk("joints.vtp"));
  EXPECT_NEAR(data->GetPoint(0)[0], 2, 1e-12);
  EXPECT_NEAR(data->GetPoint(1)[0], 7, 1e-12);
  EXPECT_NEAR(data->GetPoint(2)[0], 12, 1e-12);
  EXPECT_NEAR(data->GetPoint(3)[0], 7, 1e-12);
}

TEST(VtkJoints, EmptyFrameCanBeRead) {
  Model model = two_squares();
  model.joints.clear();
  model.contacts.clear();
  write_joints_vtp(scratch_vtk("joints.vtp"), model);
  EXPECT_EQ(read(scratch_vtk("joints.vtp"))->GetNumberOfCells(), 0);
}

// A hole of 0.2 m in two halves, the gas at 10 m/s: after 50 ms it has come 0.5 m from the centre, 0.4 of the 0.9 m of
// each joint.
TEST(VtkCracks, ShowHowFarTheGasHasCome) {
  Region halves = test::region("halves", {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  halves.holes = {{{}, "hole", {{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}}};
  halves.traces = {{{}, {{0, -2}, {0, 2}}}};
  Scene scene = test::scene_of({halves});
  scene.time = {};
  scene.time.t_end = 0.05;
  scene.time.dt = 1e-3;
  scene.charges = {
      {{}, "charge", 0, 0, 0, 0, polytropic(1e-3, 1.4), {}, [](const GasMoment&) { return 10.; }, 10., {}, {}, {}}};
  Simulation simulation(scene);
  while (!simulation.finished()) simulation.step();
  write_cracks_vtp(scratch_vtk("cracks.vtp"), simulation.model, simulation.gas());
  const auto data = read(scratch_vtk("cracks.vtp"));
  ASSERT_EQ(data->GetNumberOfCells(), 2);
  for (const int joint : {0, 1}) {
    EXPECT_NEAR(cell(data, "gas", joint), 0.4 / 0.9, 1e-3);
    EXPECT_EQ(cell(data, "gas_pressure", joint), simulation.gas()->chambers()[0].pressure);
  }
}

TEST(Pvd, ListsAllFramesSoFar) {
  PvdSeries series(std::filesystem::path(scratch_vtk("x")).parent_path().string(), "series");
  series.add(0, "a_00000.vtp");
  series.add(0.1, "a_00001.vtp");
  const std::string file = text_of(scratch_vtk("series.pvd"));
  EXPECT_NE(file.find("timestep=\"0\" part=\"0\" file=\"a_00000.vtp\""), std::string::npos);
  EXPECT_NE(file.find("timestep=\"0.1\" part=\"0\" file=\"a_00001.vtp\""), std::string::npos);
  EXPECT_NE(file.find("</VTKFile>"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(scratch_vtk("series.pvd.part")));
}

}  // namespace
}  // namespace talus
