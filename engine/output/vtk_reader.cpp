#include "output/vtk_reader.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "scene/error.h"

namespace talus {

namespace {

const ResultArray* find(const std::vector<ResultArray>& arrays, const std::string& name) {
  const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const ResultArray& a) { return a.name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

ResultArray taken(vtkDataArray* array) {
  ResultArray out;
  out.name = array->GetName() ? array->GetName() : "";
  out.components = array->GetNumberOfComponents();
  out.whole = array->GetDataType() != VTK_DOUBLE && array->GetDataType() != VTK_FLOAT;
  out.values.resize(static_cast<std::size_t>(array->GetNumberOfValues()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) array->GetTuple(i, out.values.data() + i * out.components);
  return out;
}

std::vector<ResultArray> all_of(vtkFieldData* data) {
  std::vector<ResultArray> arrays;
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
    if (vtkDataArray* array = data->GetArray(k)) arrays.push_back(taken(array));
  return arrays;
}

void take_field_data(ResultFrame& frame, vtkFieldData* data) {
  if (vtkDataArray* time = data->GetArray("TimeValue"); time && time->GetNumberOfValues() > 0)
    frame.time = time->GetTuple1(0);
  for (int k = 0; k < data->GetNumberOfArrays(); ++k) {
    auto* names = vtkStringArray::SafeDownCast(data->GetAbstractArray(k));
    if (!names || !names->GetName()) continue;
    for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
      frame.names[names->GetName()].push_back(names->GetValue(i));
  }
}

void take_cells(ResultFrame& frame, vtkPolyData* data) {
  vtkCellArray* cells = data->GetNumberOfPolys() > 0 ? data->GetPolys() : data->GetLines();
  std::vector<Vec2> points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double* p = data->GetPoint(static_cast<vtkIdType>(i));
    points[i] = {p[0], p[1]};
  }
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  frame.begin = {0};
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c) {
    cells->GetCellAtId(c, count, ids);
    for (vtkIdType k = 0; k < count; ++k) frame.points.push_back(points.at(static_cast<std::size_t>(ids[k])));
    frame.begin.push_back(static_cast<int>(frame.points.size()));
  }
}

bool ends_whole(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(-12, std::ios::end);
  std::string end(12, '\0');
  file.read(end.data(), 12);
  return end.find("</VTKFile>") != std::string::npos;
}

}  // namespace

const ResultArray* ResultFrame::cell(const std::string& name) const {
  return find(cells, name);
}

const ResultArray* ResultFrame::of_point(const std::string& name) const {
  return find(of_points, name);
}

ResultFrame read_vtp(const std::string& path) {
  const auto refuse = [&](const std::string& reason) { throw RunError("cannot read " + path + ": " + reason); };
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) refuse("there is no such file");
  if (!ends_whole(path)) refuse("it is cut short, or no .vtp file");  // VTK takes some of those for empty ones
  vtkObject::GlobalWarningDisplayOff();                               // it is said below, once
  vtkNew<vtkXMLPolyDataReader> reader;
  if (!reader->CanReadFile(path.c_str())) refuse("expected a .vtp file, got something else");
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  if (reader->GetErrorCode() != 0 || !data) refuse("VTK's reader failed; the file may be cut short");
  ResultFrame frame;
  try {
    take_cells(frame, data);
  } catch (const std::out_of_range&) {
    refuse("a cell has a point that is not in the file");
  }
  frame.cells = all_of(data->GetCellData());
  frame.of_points = all_of(data->GetPointData());
  take_field_data(frame, data->GetFieldData());
  for (const ResultArray& array : frame.cells)
    if (array.values.size() != frame.size() * static_cast<std::size_t>(array.components))
      refuse("array \"" + array.name + "\" has not one value for each of its " + std::to_string(frame.size()) +
             " cells");
  for (const ResultArray& array : frame.of_points)
    if (array.values.size() != frame.points.size() * static_cast<std::size_t>(array.components))
      refuse("array \"" + array.name + "\" has not one value for each of its points");
  return frame;
}

std::string deflated(const std::string& bytes) {
  vtkNew<vtkZLibDataCompressor> compressor;
  compressor->SetCompressionLevel(6);
  std::string out(compressor->GetMaximumCompressionSpace(bytes.size()), '\0');
  out.resize(compressor->Compress(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                                  reinterpret_cast<unsigned char*>(out.data()), out.size()));
  return out;
}

}  // namespace talus
