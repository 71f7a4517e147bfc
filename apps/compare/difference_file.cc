// SPDX-License-Identifier: BSD-3-Clause
#include <apps/compare/compared_fields.h>
#include <apps/output/growing_file.h>

#include <fmt/format.h>
#include <system_error>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

namespace tamp::apps
{
namespace
{
void add_array(vtkDataSetAttributes &attributes,
               const std::string &name,
               const std::vector<double> &values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  for (const double value : values)
    array->InsertNextValue(value);
  attributes.AddArray(array);
}

void add_mesh(const FieldGrid &fields, vtkUnstructuredGrid &grid)
{
  constexpr std::array<vtkIdType, 8> order{0, 1, 3, 2, 4, 5, 7, 6};
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Place &place : fields.undeformed)
    points->InsertNextPoint(place.data());
  grid.SetPoints(points);
  for (std::size_t part = 0; part < fields.parts(); ++part) {
    std::array<vtkIdType, 8> ids{};
    for (unsigned corner = 0; corner < fields.corners(); ++corner)
      ids[corner] =
          static_cast<vtkIdType>(part * fields.corners()) + order[corner];
    grid.InsertNextCell(fields.dimension == 2 ? VTK_QUAD : VTK_HEXAHEDRON,
                        fields.corners(),
                        ids.data());
  }
}

void add_displacement(const FieldGrid &fields,
                      const std::string &name,
                      vtkUnstructuredGrid &grid)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < fields.now.size(); ++i)
    array->InsertNextTuple3(fields.now[i][0] - fields.undeformed[i][0],
                            fields.now[i][1] - fields.undeformed[i][1],
                            fields.now[i][2] - fields.undeformed[i][2]);
  grid.GetPointData()->AddArray(array);
}
} // namespace

void write_differences(const std::filesystem::path &file,
                       const std::vector<ComparedState> &states,
                       const std::vector<std::string> &names)
{
  vtkNew<vtkUnstructuredGrid> grid;
  add_mesh(states.front().reference, *grid);
  for (const ComparedState &state : states) {
    const std::string &when = state.state.name;
    add_displacement(state.reference, when + "_displacement", *grid);
    for (const auto &[name, values] : state.reference.values)
      add_array(*grid->GetCellData(), when + "_" + name, values);
    for (std::size_t run = 0; run < state.others.size(); ++run)
      for (const auto &[name, values] : state.others[run].values)
        add_array(
            *grid->GetCellData(),
            fmt::format("{}_{}_difference_{}", when, name, names[run + 1]),
            values);
  }
  std::filesystem::path part = file;
  part += ".part";
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(part.c_str());
  writer->SetInputData(grid);
  writer->SetDataModeToBinary();
  std::error_code error;
  if (writer->Write() == 1)
    std::filesystem::rename(part, file, error);
  if (writer->GetErrorCode() != 0 || error)
    throw OutputError(fmt::format("'{}' cannot be written", file.string()));
}
} // namespace tamp::apps
