// SPDX-License-Identifier: BSD-3-Clause
#include <apps/compare/field_grid.h>
#include <apps/input/units.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <vtkCallbackCommand.h>
#include <vtkCellType.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProbeFilter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace tamp::apps
{
namespace
{
// VTK's order of corners in ours, and the other way round.
constexpr std::array<vtkIdType, 8> vtk_order{0, 1, 3, 2, 4, 5, 7, 6};
const double gauss = 1 / std::sqrt(3.);

bool is_wanted(const std::string &name)
{
  return name == "relative_density" || name == "pressure" ||
         name == "deviatoric_stress" || name.starts_with("stress_");
}

unsigned dimension_of(vtkUnstructuredGrid &grid)
{
  const vtkIdType count = grid.GetNumberOfCells();
  if (count == 0 || !grid.GetPoints())
    return 0;
  const int type = grid.GetCellType(0);
  for (vtkIdType cell = 0; cell < count; ++cell)
    if (grid.GetCellType(cell) != type)
      return 0;
  const unsigned dimension = type == VTK_QUAD         ? 2
                             : type == VTK_HEXAHEDRON ? 3
                                                      : 0;
  return dimension > 0 && count % (1 << dimension) == 0 ? dimension : 0;
}

// The points of the grid that are the corners, in our order.
std::vector<vtkIdType> corner_points(vtkUnstructuredGrid &grid,
                                     unsigned dimension)
{
  std::vector<vtkIdType> points;
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell) {
    vtkIdType count = 0;
    const vtkIdType *ids = nullptr;
    grid.GetCellPoints(cell, count, ids);
    for (unsigned corner = 0; corner < 1u << dimension; ++corner)
      points.push_back(ids[vtk_order[corner]]);
  }
  return points;
}

void take_places(vtkUnstructuredGrid &grid,
                 const std::vector<vtkIdType> &points,
                 FieldGrid &fields)
{
  vtkDataArray *moved = grid.GetPointData()->GetArray("displacement");
  fields.knows_displacement = moved && moved->GetNumberOfComponents() == 3;
  for (const vtkIdType point : points) {
    Place place;
    grid.GetPoint(point, place.data());
    fields.now.push_back(place);
    if (fields.knows_displacement)
      for (int axis = 0; axis < 3; ++axis)
        place[axis] -= moved->GetComponent(point, axis);
    fields.undeformed.push_back(place);
  }
}

// The multilinear function with these values at the ends of [0, 1] an axis.
template <class Value>
Value interpolate(unsigned dimension,
                  const Value *corners,
                  const Place &at,
                  auto add)
{
  Value sum{};
  for (unsigned corner = 0; corner < 1u << dimension; ++corner) {
    double weight = 1;
    for (unsigned axis = 0; axis < dimension; ++axis)
      weight *= corner >> axis & 1 ? at[axis] : 1 - at[axis];
    add(sum, weight, corners[corner]);
  }
  return sum;
}

Place place_in(unsigned dimension, const Place *corners, const Place &at)
{
  return interpolate(dimension,
                     corners,
                     at,
                     [](Place &sum, double weight, const Place &corner) {
                       for (int axis = 0; axis < 3; ++axis)
                         sum[axis] += weight * corner[axis];
                     });
}

// Volume of the unit cell of a part's coordinates at a place in it.
double volume_ratio(unsigned dimension, const Place *corners, const Place &at)
{
  std::array<Place, 3> tangent{Place{1, 0, 0}, Place{0, 1, 0}, Place{0, 0, 1}};
  for (unsigned axis = 0; axis < dimension; ++axis) {
    Place begin = at, end = at;
    begin[axis] = 0;
    end[axis] = 1;
    const Place from = place_in(dimension, corners, begin);
    const Place to = place_in(dimension, corners, end);
    for (int k = 0; k < 3; ++k)
      tangent[axis][k] = to[k] - from[k];
  }
  const auto &[a, b, c] = tangent;
  const double ratio = a[0] * (b[1] * c[2] - b[2] * c[1]) +
                       a[1] * (b[2] * c[0] - b[0] * c[2]) +
                       a[2] * (b[0] * c[1] - b[1] * c[0]);
  if (dimension == 3)
    return ratio;
  return 2 * std::numbers::pi * place_in(2, corners, at)[0] * ratio;
}

// Of a part in an element, by its number there: where its corners lie in the
// cube whose corners are the element's material points.
Place corner_among_points(unsigned part, unsigned corner)
{
  Place at{};
  for (unsigned axis = 0; axis < 3; ++axis) {
    const double place =
        (part >> axis & 1) + (corner >> axis & 1) - 1.; // -1,0,1
    at[axis] = 0.5 * (1 + place / gauss);
  }
  return at;
}

std::vector<double> corner_values(const FieldGrid &grid,
                                  const std::vector<double> &values)
{
  std::vector<double> all;
  for (std::size_t part = 0; part < grid.parts(); ++part) {
    const unsigned number = part % grid.corners();
    for (unsigned corner = 0; corner < grid.corners(); ++corner)
      all.push_back(interpolate(grid.dimension,
                                &values[part - number],
                                corner_among_points(number, corner),
                                [](double &sum, double weight, double value) {
                                  sum += weight * value;
                                }));
  }
  return all;
}

vtkNew<vtkPoints> points_of(std::span<const Place> places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Place &place : places)
    points->InsertNextPoint(place.data());
  return points;
}

// In undeformed places, with values at the corners.
vtkNew<vtkUnstructuredGrid> undeformed_grid(const FieldGrid &grid)
{
  vtkNew<vtkUnstructuredGrid> result;
  result->SetPoints(points_of(grid.undeformed));
  result->Allocate(static_cast<vtkIdType>(grid.parts()));
  for (std::size_t part = 0; part < grid.parts(); ++part) {
    std::array<vtkIdType, 8> ids;
    for (unsigned corner = 0; corner < grid.corners(); ++corner)
      ids[corner] =
          static_cast<vtkIdType>(part * grid.corners()) + vtk_order[corner];
    result->InsertNextCell(grid.dimension == 2 ? VTK_QUAD : VTK_HEXAHEDRON,
                           grid.corners(),
                           ids.data());
  }
  for (const auto &[name, values] : grid.values) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name.c_str());
    for (const double value : corner_values(grid, values))
      array->InsertNextValue(value);
    result->GetPointData()->AddArray(array);
  }
  return result;
}
} // namespace

FieldGrid read_fields(const std::filesystem::path &file)
{
  const auto wrong = [&](const std::string &problem) {
    return InputError(fmt::format("'{}' {}", file.string(), problem));
  };
  if (!std::filesystem::is_regular_file(file))
    throw wrong("is missing, though fields.pvd names it");
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  vtkNew<vtkCallbackCommand> silence; // what is wrong is said below
  reader->AddObserver(vtkCommand::ErrorEvent, silence);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
  reader->SetReaderErrorObserver(silence);
  reader->SetParserErrorObserver(silence);
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkUnstructuredGrid *grid = reader->GetOutput();
  FieldGrid fields;
  fields.dimension = reader->GetErrorCode() == 0 ? dimension_of(*grid) : 0;
  if (fields.dimension == 0)
    throw wrong("is damaged, or no field file of tamp die");
  const auto points = corner_points(*grid, fields.dimension);
  take_places(*grid, points, fields);
  for (int i = 0; i < grid->GetPointData()->GetNumberOfArrays(); ++i) {
    vtkDataArray *array = grid->GetPointData()->GetArray(i);
    if (!array || !array->GetName() || !is_wanted(array->GetName()))
      continue;
    auto &values = fields.values[array->GetName()];
    for (std::size_t part = 0; part < fields.parts(); ++part)
      values.push_back(array->GetComponent(points[part * fields.corners()], 0));
  }
  if (!fields.values.contains("relative_density"))
    throw wrong("has no relative_density: it is no field file of tamp die");
  return fields;
}

bool same_mesh(const FieldGrid &first, const FieldGrid &second)
{
  if (first.dimension != second.dimension ||
      first.undeformed.size() != second.undeformed.size() ||
      !first.knows_displacement || !second.knows_displacement)
    return false;
  double size = 0, distance = 0;
  for (std::size_t i = 0; i < first.undeformed.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const double a = first.undeformed[i][axis];
      size = std::max(size, std::abs(a));
      distance = std::max(distance, std::abs(second.undeformed[i][axis] - a));
    }
  return distance <= 1e-5 * size;
}

std::vector<double> part_volumes(unsigned dimension,
                                 std::span<const Place> corners)
{
  const unsigned count = 1u << dimension;
  std::vector<double> volumes;
  for (std::size_t first = 0; first < corners.size(); first += count) {
    double volume = 0;
    for (unsigned point = 0; point < count; ++point) {
      Place at{};
      for (unsigned axis = 0; axis < dimension; ++axis)
        at[axis] = 0.5 * (1 + (point >> axis & 1 ? gauss : -gauss));
      volume += volume_ratio(dimension, &corners[first], at) / count;
    }
    volumes.push_back(volume);
  }
  return volumes;
}

std::vector<Place> point_places(unsigned dimension,
                                std::span<const Place> corners)
{
  const unsigned count = 1u << dimension;
  std::vector<Place> places;
  for (std::size_t part = 0; part < corners.size() / count; ++part) {
    Place at{};
    for (unsigned axis = 0; axis < dimension; ++axis)
      at[axis] = part >> axis & 1 ? gauss : 1 - gauss;
    places.push_back(place_in(dimension, &corners[part * count], at));
  }
  return places;
}

Extent extent_of(const FieldGrid &grid)
{
  Extent extent;
  extent.low.fill(std::numeric_limits<double>::max());
  for (const Place &place : grid.undeformed)
    for (int axis = 0; axis < 3; ++axis) {
      extent.low[axis] = std::min(extent.low[axis], place[axis]);
      extent.size[axis] = std::max(extent.size[axis], std::abs(place[axis]));
    }
  const unsigned height = grid.dimension - 1;
  for (unsigned axis = 0; axis < 3; ++axis)
    if (axis != height)
      extent.low[axis] = 0;
  extent.size[height] = 0;
  for (const Place &place : grid.undeformed)
    extent.size[height] =
        std::max(extent.size[height], place[height] - extent.low[height]);
  return extent;
}

void normalise(FieldGrid &grid)
{
  const Extent extent = extent_of(grid);
  for (Place &place : grid.undeformed)
    for (unsigned axis = 0; axis < grid.dimension; ++axis)
      place[axis] = (place[axis] - extent.low[axis]) / extent.size[axis];
}

SampledFields sample(const FieldGrid &grid, std::span<const Place> places)
{
  vtkNew<vtkPolyData> at;
  at->SetPoints(points_of(places));
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(at);
  probe->SetSourceData(undeformed_grid(grid));
  probe->Update();
  vtkPointData *data = probe->GetOutput()->GetPointData();
  SampledFields sampled;
  vtkDataArray *mask = data->GetArray(probe->GetValidPointMaskArrayName());
  for (std::size_t i = 0; i < places.size(); ++i)
    sampled.inside.push_back(
        mask && mask->GetComponent(static_cast<vtkIdType>(i), 0) > 0);
  for (const auto &[name, values] : grid.values) {
    vtkDataArray *array = data->GetArray(name.c_str());
    for (std::size_t i = 0; array && i < places.size(); ++i)
      sampled.values[name].push_back(
          array->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  return sampled;
}
} // namespace tamp::apps
