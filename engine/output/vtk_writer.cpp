#include "output/vtk_writer.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkVersionMacros.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>

#include "gas/gas.h"
#include "output/files.h"
#include "scene/error.h"

namespace talus {

namespace {

// Beside `id`, which counts from 1 as in Lua.
constexpr std::array block_arrays = {"region",   "material", "order", "fixed",  "fragment",     "displacement",
                                     "velocity", "rotation", "spin",  "strain", "sxx",          "syy",
                                     "sxy",      "szz",      "s1",    "s2",     "s1_direction", "mises"};

constexpr std::array crack_arrays = {"failed_at", "utilisation", "opening", "slip", "cohesion", "tension", "friction"};

constexpr std::array smoothed_arrays = {"sxx_smooth", "syy_smooth", "sxy_smooth", "s1_smooth", "s2_smooth"};

// One value, or one vector (padded to three components: ParaView takes others for no vectors), an item.
template <class Array, class Value>
void add_array(vtkFieldData* data, const std::string& name, int components, vtkIdType items, Value value) {
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components == 1 ? 1 : 3);
  array->SetNumberOfTuples(items);
  for (vtkIdType i = 0; i < items; ++i) {
    double tuple[3] = {0, 0, 0};
    value(static_cast<int>(i), tuple);
    array->SetTuple(i, tuple);
  }
  data->AddArray(array);
}

void add_field(vtkFieldData* data, const FieldContext& context, const Field& field, vtkIdType items) {
  const auto value = [&](int id, double* out) { field.get(context, id, out); };
  if (field.whole) {
    add_array<vtkIntArray>(data, field.name, 1, items, value);
  } else {
    add_array<vtkDoubleArray>(data, field.name, field.components, items, value);
  }
}

void add_names(vtkFieldData* data, const std::string& name, const std::vector<std::string>& values) {
  vtkNew<vtkStringArray> array;
  array->SetName(name.c_str());
  for (const std::string& value : values) array->InsertNextValue(value);
  data->AddArray(array);
}

template <class Item>
std::vector<std::string> names_of(const std::vector<Item>& items) {
  std::vector<std::string> names;
  for (const Item& item : items) names.push_back(item.name);
  return names;
}

// "TimeValue" is what VTK's readers take for the time of a file.
void add_time(vtkFieldData* data, double time) {
  add_array<vtkDoubleArray>(data, "TimeValue", 1, 1, [&](int, double* out) { *out = time; });
}

void write(const std::string& path, vtkPolyData* data) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToLZ4();
  writer->WriteToOutputStringOn();
  if (writer->Write() != 1) throw RunError("cannot write " + path + ": VTK's writer failed");
  write_whole(path, writer->GetOutputString());
}

void add_polygons(vtkPolyData* data, const Model& model) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(model.vertex.size()));
  vtkNew<vtkCellArray> polygons;
  for (int b = 0; b < int(model.shapes.size()); ++b) {
    const BlockShape& shape = model.shapes[b];
    polygons->InsertNextCell(shape.vertex_end - shape.vertex_begin);
    for (int v = shape.vertex_begin; v < shape.vertex_end; ++v) {
      const Vec2 p = model.vertex[size_t(v)] + model.origin;
      points->SetPoint(v, p.x(), p.y(), 0);
      polygons->InsertCellPoint(v);
    }
  }
  data->SetPoints(points);
  data->SetPolys(polygons);
}

// Of the corners, for "warp by vector".
void add_point_displacement(vtkPolyData* data, const Model& model) {
  std::vector<Vec2> moved(model.vertex.size());
  for (int b = 0; b < int(model.shapes.size()); ++b) {
    const BlockShape& shape = model.shapes[b];
    for (int v = shape.vertex_begin; v < shape.vertex_end; ++v)
      moved[v] = model.vertex[size_t(v)] - shape.reference_centroid - model.reference_vertex[v];
  }
  add_array<vtkDoubleArray>(data->GetPointData(), "displacement", 2, static_cast<vtkIdType>(moved.size()),
                            [&](int v, double* out) { std::copy_n(moved[v].data(), 2, out); });
}

struct Line {
  int id, block_a, block_b;  // from 1, as in Lua: of the joint or contact; of a contact, vertex and edge
  Vec2 from, to;
  int kind, state, property;  // 0 joint, 1 contact; index into line_states
  double normal, shear;       // Pa, tension positive
  double opening, slip;       // m
  double utilisation;         // of a joint
};
const std::vector<std::string> line_kinds = {"joint", "contact"};
const std::vector<std::string> line_states = {"intact", "failed", "open", "stick", "slip"};
constexpr int first_contact_state = 2;

double value_of(const FieldContext& context, std::span<const Field> fields, const char* name, int id) {
  double value = 0;
  find_field(fields, name)->get(context, id, &value);
  return value;
}

Line joint_line(const FieldContext& context, int id) {
  const Model& model = context.model;
  const Joint& joint = model.joints[id];
  const auto end = [&](int k) -> Vec2 {
    return (model.place(joint.a, joint.in_a[k]) + model.place(joint.b, joint.in_b[k])) / 2;
  };
  const auto value = [&](const char* name) { return value_of(context, joint_fields(), name, id); };
  return {id + 1,
          joint.a + 1,
          joint.b + 1,
          end(0),
          end(1),
          0,
          static_cast<int>(joint.state),
          joint.property,
          value("normal_traction"),
          value("shear_traction"),
          value("opening"),
          value("slip"),
          value("utilisation")};
}

// The part of the edge `from` + s·`span`, s in 0–1, that the contact stands for: from the foot of the corner along the
// face that its block turns to the edge, half of what the two share; the corner at the other end has the other half.
// Nothing where no edge of the corner lies along this one.
std::pair<double, double> shared_part(const Model& model, const Contact& contact, const Vec2& from, const Vec2& span) {
  constexpr double parallel_sine = 0.052;  // as in the search for contacts
  const double length2 = span.squaredNorm();
  const auto place = [&](const Vec2& p) { return std::clamp((p - from).dot(span) / length2, 0.0, 1.0); };
  const BlockShape& shape = model.shapes[contact.i];
  const Vec2 corner = model.vertex[contact.global_vertex];
  const double foot = place(corner);
  const int count = model.vertex_count(contact.i);
  double reach = 0;
  for (const int other : {(contact.vertex + 1) % count, (contact.vertex + count - 1) % count}) {
    const Vec2 along = model.vertex[shape.vertex_begin + other] - corner;
    if (std::abs(cross(span, along)) > parallel_sine * span.norm() * along.norm()) continue;
    const double part = place(corner + along) - foot;
    if (std::abs(part) > std::abs(reach)) reach = part;
  }
  return {foot, foot + reach / 2};
}

Line contact_line(const FieldContext& context, int id) {
  constexpr double least_share = 0.02;  // of the edge, so that a contact without length is seen too
  const Model& model = context.model;
  const Contact& contact = model.contacts[id];
  const Vec2 from = model.vertex[contact.global_edge];
  const Vec2 edge =
      model.vertex[model.shapes[contact.j].vertex_begin + model.next_vertex(contact.j, contact.edge)] - from;
  auto [begin, end] = shared_part(model, contact, from, edge);
  if (contact.kind != ContactKind::edge_edge || begin == end) {
    end = std::clamp(begin + least_share / 2, least_share, 1.0);
    begin = end - least_share;
  }
  const auto value = [&](const char* name) { return value_of(context, contact_fields(), name, id); };
  return {id + 1,
          contact.i + 1,
          contact.j + 1,
          from + begin * edge,
          from + end * edge,
          1,
          first_contact_state + static_cast<int>(contact.state),
          contact.property,
          value("normal_traction"),
          value("shear_traction"),
          contact.gap,
          contact.slip,
          0};
}

void add_lines(vtkPolyData* data, const std::vector<Line>& lines, const Vec2& origin) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Line& line : lines) {
    cells->InsertNextCell(2);
    for (const Vec2& end : {line.from, line.to})
      cells->InsertCellPoint(points->InsertNextPoint(end.x() + origin.x(), end.y() + origin.y(), 0));
  }
  data->SetPoints(points);
  data->SetLines(cells);
}

template <class Array, class Member>
void add_member(vtkPolyData* data, const std::string& name, const std::vector<Line>& lines, Member member) {
  add_array<Array>(data->GetCellData(), name, 1, static_cast<vtkIdType>(lines.size()),
                   [&](int i, double* out) { *out = lines[i].*member; });
}

}  // namespace

void write_blocks_vtp(const std::string& path, const FieldContext& context, const std::vector<UserArray>& arrays) {
  const Model& model = context.model;
  const auto blocks = static_cast<vtkIdType>(model.shapes.size());
  vtkNew<vtkPolyData> data;
  add_polygons(data, model);
  add_point_displacement(data, model);
  vtkCellData* cells = data->GetCellData();
  add_array<vtkIntArray>(cells, "id", 1, blocks, [](int b, double* out) { *out = b + 1; });
  for (const char* name : block_arrays) add_field(cells, context, *find_field(block_fields(), name), blocks);
  const char* components[] = {"exx", "eyy", "gxy"};  // the last one is engineering shear
  for (int k = 0; k < 3; ++k) cells->GetArray("strain")->SetComponentName(k, components[k]);
  if (context.recovery) {
    const std::vector<Vec3> smoothed = context.smoothed ? *context.smoothed : smoothed_stresses(context);
    for (const char* name : smoothed_arrays)
      add_field(cells, {model, context.recovery, &smoothed}, *find_field(block_fields(), name), blocks);
    if (model.scene.output.error) add_field(cells, context, *find_field(block_fields(), "stress_error"), blocks);
  }
  for (const UserArray& array : arrays)
    add_array<vtkDoubleArray>(cells, array.name, 1, blocks, [&](int b, double* out) { *out = array.values[b]; });
  add_names(data->GetFieldData(), "region_names", names_of(model.scene.regions));
  add_names(data->GetFieldData(), "material_names", names_of(model.scene.materials));
  add_time(data->GetFieldData(), model.time);
  write(path, data);
}

void write_joints_vtp(const std::string& path, const Model& model) {
  const FieldContext context = {model, nullptr};
  std::vector<Line> lines;
  for (int id = 0; id < static_cast<int>(model.joints.size()); ++id) lines.push_back(joint_line(context, id));
  for (int id = 0; id < static_cast<int>(model.contacts.size()); ++id) lines.push_back(contact_line(context, id));
  vtkNew<vtkPolyData> data;
  add_lines(data, lines, model.origin);
  add_member<vtkIntArray>(data, "id", lines, &Line::id);
  add_member<vtkIntArray>(data, "block_a", lines, &Line::block_a);
  add_member<vtkIntArray>(data, "block_b", lines, &Line::block_b);
  add_member<vtkIntArray>(data, "kind", lines, &Line::kind);
  add_member<vtkIntArray>(data, "state", lines, &Line::state);
  add_member<vtkIntArray>(data, "property", lines, &Line::property);
  add_member<vtkDoubleArray>(data, "normal_traction", lines, &Line::normal);
  add_member<vtkDoubleArray>(data, "shear_traction", lines, &Line::shear);
  add_member<vtkDoubleArray>(data, "opening", lines, &Line::opening);
  add_member<vtkDoubleArray>(data, "slip", lines, &Line::slip);
  add_member<vtkDoubleArray>(data, "utilisation", lines, &Line::utilisation);
  if (model.scene.output.error)
    add_array<vtkDoubleArray>(
        data->GetCellData(), "traction_jump", 1, static_cast<vtkIdType>(lines.size()), [&](int i, double* out) {
          *out = lines[i].kind == 0 ? value_of(context, joint_fields(), "traction_jump", lines[i].id - 1) : 0;
        });
  add_names(data->GetFieldData(), "kind_names", line_kinds);
  add_names(data->GetFieldData(), "state_names", line_states);
  add_names(data->GetFieldData(), "property_names", names_of(model.scene.properties));
  add_time(data->GetFieldData(), model.time);
  write(path, data);
}

namespace {

struct GasInJoint {
  double part = 0, pressure = 0;  // of its length that the gas has entered; Pa
};

std::vector<GasInJoint> gas_in_joints(const Model& model, const Gas& gas) {
  std::vector<GasInJoint> in(model.joints.size());
  for (size_t c = 0; c < gas.chambers().size(); ++c) {
    if (gas.chambers()[c].state == Chamber::State::merged) continue;
    for (const ReachedJoint& r : gas.reach(int(c)).joints) {
      in[r.joint].part = std::min(1.0, in[r.joint].part + r.to - r.from);
      in[r.joint].pressure = std::max(in[r.joint].pressure, gas.chambers()[c].pressure);
    }
  }
  return in;
}

}  // namespace

void write_cracks_vtp(const std::string& path, const Model& model, const Gas* gas) {
  std::vector<int> failed;
  for (int id = 0; id < static_cast<int>(model.joints.size()); ++id)
    if (model.joints[id].state == JointState::failed) failed.push_back(id);
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const int id : failed) {
    const Joint& joint = model.joints[id];
    lines->InsertNextCell(2);
    for (const int end : {0, 1}) {
      const Vec2 at =
          (model.place(joint.a, joint.in_a[end]) + model.place(joint.b, joint.in_b[end])) / 2 + model.origin;
      lines->InsertCellPoint(points->InsertNextPoint(at.x(), at.y(), 0));
    }
  }
  data->SetPoints(points);
  data->SetLines(lines);
  const FieldContext context = {model, nullptr};
  const auto count = static_cast<vtkIdType>(failed.size());
  vtkCellData* cells = data->GetCellData();
  const auto value = [&](const char* name, int shift) {
    return [&context, &failed, shift, &field = *find_field(joint_fields(), name)](int i, double* out) {
      field.get(context, failed[i], out);
      *out += shift;
    };
  };
  // Numbers of joints and blocks count from 1, as in Lua.
  for (const auto& [name, shift] : {std::pair{"id", 1}, {"block_a", 1}, {"block_b", 1}, {"mode", 0}, {"crack", 0}})
    add_array<vtkIntArray>(cells, name, 1, count, value(name, shift));
  for (const char* name : crack_arrays) add_array<vtkDoubleArray>(cells, name, 1, count, value(name, 0));
  if (gas) {
    const std::vector<GasInJoint> in = gas_in_joints(model, *gas);
    add_array<vtkDoubleArray>(cells, "gas", 1, count, [&](int i, double* out) { *out = in[failed[i]].part; });
    add_array<vtkDoubleArray>(cells, "gas_pressure", 1, count,
                              [&](int i, double* out) { *out = in[failed[i]].pressure; });
  }
  add_names(data->GetFieldData(), "mode_names", {"real joint", "tension", "shear"});
  add_names(data->GetFieldData(), "crack_names", {"real joint", "initiated", "propagated", "coalesced"});
  add_time(data->GetFieldData(), model.time);
  write(path, data);
}

std::string vtk_version() {
  return VTK_VERSION;
}

}  // namespace talus
