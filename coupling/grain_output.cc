// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/grain_output.h>
#include <dem/measures.h>

#include <cmath>
#include <fstream>
#include <stdexcept>
#include <vector>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

namespace tamp::coupling
{
namespace
{
enum Kind { grain = 0, contact = 1, edge = 2 };

/// Collects points and cells; vertices must come before lines, as VTK numbers
/// them.
class Picture
{
public:
  explicit Picture(const dem::Matrix3 &rotation) : rotation_(rotation)
  {
    points_->SetDataTypeToDouble();
    name(radius_, "radius");
    name(normal_, "normal_force");
    name(tangential_, "tangential_force");
    number_->SetName("grain");
    kind_->SetName("kind");
    plastic_->SetName("plastic");
    sliding_->SetName("sliding");
  }

  vtkIdType add_point(const dem::Vector3 &x, double radius, int number)
  {
    const dem::Vector3 y = rotation_ * x;
    radius_->InsertNextValue(radius);
    number_->InsertNextValue(number);
    return points_->InsertNextPoint(y.data());
  }
  void add_vertex(vtkIdType point)
  {
    vertices_->InsertNextCell(1, &point);
    add_values(grain, 0, 0, false, false);
  }
  void add_line(vtkIdType from, vtkIdType to)
  {
    const vtkIdType ends[2] = {from, to};
    lines_->InsertNextCell(2, ends);
  }
  void add_values(Kind kind, double n, double t, bool plastic, bool sliding)
  {
    kind_->InsertNextValue(kind);
    normal_->InsertNextValue(n);
    tangential_->InsertNextValue(t);
    plastic_->InsertNextValue(plastic);
    sliding_->InsertNextValue(sliding);
  }

  void write(const std::filesystem::path &file)
  {
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_);
    data->SetVerts(vertices_);
    data->SetLines(lines_);
    data->GetPointData()->AddArray(radius_);
    data->GetPointData()->AddArray(number_);
    for (vtkDataArray *array : std::initializer_list<vtkDataArray *>{
             kind_, normal_, tangential_, plastic_, sliding_})
      data->GetCellData()->AddArray(array);
    const std::filesystem::path part = file.string() + ".part";
    if (!std::ofstream(part)) // VTK would only print
      throw std::runtime_error("cannot write '" + file.string() + "'");
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(part.c_str());
    writer->SetInputData(data);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    if (writer->Write() != 1)
      throw std::runtime_error("cannot write '" + file.string() + "'");
    std::filesystem::rename(part, file);
  }

private:
  static void name(vtkDataArray *array, const char *text)
  {
    array->SetName(text);
  }

  dem::Matrix3 rotation_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> vertices_, lines_;
  vtkNew<vtkDoubleArray> radius_, normal_, tangential_;
  vtkNew<vtkIntArray> number_, kind_, plastic_, sliding_;
};

/// The place of a grain inside the cell [m].
dem::Vector3 inside(const dem::UnitCell &cell, std::size_t i)
{
  dem::Vector3 s = cell.place[i];
  for (int a = 0; a < 3; ++a)
    s[a] -= std::floor(s[a]);
  return cell.box.h * s;
}

void add_edges(const dem::UnitCell &cell, Picture &picture)
{
  std::vector<vtkIdType> corner;
  for (int k = 0; k < 8; ++k)
    corner.push_back(picture.add_point(
        cell.box.h * dem::Vector3(k & 1, (k >> 1) & 1, (k >> 2) & 1), 0, -1));
  for (int k = 0; k < 8; ++k)
    for (int bit : {1, 2, 4})
      if (!(k & bit)) {
        picture.add_line(corner[k], corner[k | bit]);
        picture.add_values(edge, 0, 0, false, false);
      }
}
} // namespace

void write_grains(const dem::UnitCell &cell,
                  const dem::Matrix3 &rotation,
                  const std::filesystem::path &file)
{
  Picture picture(rotation);
  for (std::size_t i = 0; i < cell.size(); ++i)
    picture.add_vertex(
        picture.add_point(inside(cell, i), cell.radius[i], int(i)));
  for (const dem::ContactForce &c : dem::contact_forces(cell)) {
    const dem::Vector3 start = inside(cell, c.pair.first);
    picture.add_line(picture.add_point(start, 0, -1),
                     picture.add_point(start + c.branch, 0, -1));
    picture.add_values(contact,
                       c.normal_force,
                       c.tangential_force.norm(),
                       c.plastic,
                       c.sliding);
  }
  add_edges(cell, picture);
  picture.write(file);
}
} // namespace tamp::coupling
