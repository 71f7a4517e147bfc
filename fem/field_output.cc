// SPDX-License-Identifier: BSD-3-Clause
#include <fem/field_output.h>

#include <deal.II/base/data_out_base.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <tuple>

namespace tamp::fem
{
namespace
{
using Patch = dealii::DataOutBase::Patch<2, 2>;

class PointPatches : public dealii::DataOutInterface<2, 2>
{
public:
  std::vector<Patch> patches;
  std::vector<std::string> names;

protected:
  const std::vector<Patch> &get_patches() const override { return patches; }
  std::vector<std::string> get_dataset_names() const override { return names; }
  std::vector<std::tuple<
      unsigned int,
      unsigned int,
      std::string,
      dealii::DataComponentInterpretation::DataComponentInterpretation>>
  get_nonscalar_data_ranges() const override
  {
    return {{0,
             1,
             "displacement",
             dealii::DataComponentInterpretation::
                 component_is_part_of_vector}};
  }
};

/// Fields of all points that the state holds.
std::vector<PointField> fields_of(const CompactState &state)
{
  std::vector<PointField> fields = {{"stress_rr", {}},
                                    {"stress_tt", {}},
                                    {"stress_zz", {}},
                                    {"stress_rz", {}},
                                    {"pressure", {}},
                                    {"deviatoric_stress", {}},
                                    {"relative_density", {}},
                                    {"point", {}}};
  for (std::size_t point = 0; point < state.responses.size(); ++point) {
    const auto stress = -state.responses[point].stress;
    const double values[] = {
        stress[0][0],
        stress[1][1],
        stress[2][2],
        stress[0][2],
        dealii::trace(stress) / 3,
        std::sqrt(1.5) * dealii::deviator(stress).norm(),
        state.responses[point].relative_density,
        static_cast<double>(point)};
    for (std::size_t i = 0; i < fields.size(); ++i)
      fields[i].values.push_back(values[i]);
  }
  return fields;
}

/// Bilinear value at a corner of the sub-square `quarter` of a cell.
template <class Value>
Value corner_value(const std::array<Value, 4> &nodal,
                   unsigned quarter,
                   unsigned corner)
{
  const double x = 0.5 * (quarter % 2 + corner % 2);
  const double y = 0.5 * (quarter / 2 + corner / 2);
  return (1 - y) * ((1 - x) * nodal[0] + x * nodal[1]) +
         y * ((1 - x) * nodal[2] + x * nodal[3]);
}

Patch make_patch(std::size_t point,
                 const DieMesh::Data &mesh,
                 const CompactState &state,
                 const std::vector<PointField> &fields)
{
  Patch patch;
  patch.patch_index = point;
  patch.n_subdivisions = 1;
  patch.reference_cell = dealii::ReferenceCells::Quadrilateral;
  patch.data.reinit(2 + fields.size(), 4);
  std::array<dealii::Tensor<1, 2>, 4> position, displacement;
  for (unsigned a = 0; a < 4; ++a) {
    const unsigned node = mesh.cells[point / 4][a];
    position[a] = state.positions[node];
    displacement[a] = position[a] - mesh.nodes[node];
  }
  for (unsigned corner = 0; corner < 4; ++corner) {
    patch.vertices[corner] =
        dealii::Point<2>(corner_value(position, point % 4, corner));
    const auto u = corner_value(displacement, point % 4, corner);
    patch.data(0, corner) = u[0];
    patch.data(1, corner) = u[1];
    for (std::size_t i = 0; i < fields.size(); ++i)
      patch.data(2 + i, corner) = fields[i].values[point];
  }
  return patch;
}

std::string with_units(const std::string &vtu)
{
  const std::string units =
      "<!-- Half section of a compact: x = r, y = z [m]. displacement [m] since "
      "the start;\n     stress_*, pressure [Pa], compression positive (r radial, "
      "t hoop, z axial);\n     deviatoric_stress: von Mises [Pa]; "
      "relative_density [-]. One quadrilateral a material point. -->\n";
  const std::size_t line = vtu.find('\n');
  return vtu.substr(0, line + 1) + units + vtu.substr(line + 1);
}

void replace_file(const std::filesystem::path &file, const std::string &content)
{
  std::filesystem::path temporary = file;
  temporary += ".part";
  {
    std::ofstream stream(temporary, std::ios::binary);
    stream << content;
    stream.close();
    if (!stream)
      throw std::runtime_error("cannot write '" + file.string() + "'");
  }
  std::error_code error;
  std::filesystem::rename(temporary, file, error);
  if (error)
    throw std::runtime_error("cannot write '" + file.string() +
                             "': " + error.message());
}
} // namespace

void write_compact(const std::filesystem::path &file,
                   const DieMesh::Data &mesh,
                   const CompactState &state,
                   const std::vector<PointField> &extra)
{
  std::vector<PointField> fields = fields_of(state);
  for (const PointField &field : extra) {
    if (field.values.size() != mesh.number_of_points())
      throw std::invalid_argument("field '" + field.name +
                                  "' does not have one value a point");
    fields.push_back(field);
  }
  PointPatches output;
  output.names = {"displacement", "displacement"};
  for (const PointField &field : fields)
    output.names.push_back(field.name);
  for (std::size_t point = 0; point < mesh.number_of_points(); ++point)
    output.patches.push_back(make_patch(point, mesh, state, fields));
  dealii::DataOutBase::VtkFlags flags;
  flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
  flags.print_date_and_time = false; // the same run writes the same file
  output.set_flags(flags);
  std::ostringstream text;
  output.write_vtu(text);
  replace_file(file, with_units(text.str()));
}
} // namespace tamp::fem
