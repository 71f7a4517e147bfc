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
namespace Interpretation = dealii::DataComponentInterpretation;
using Range = std::tuple<unsigned int,
                         unsigned int,
                         std::string,
                         Interpretation::DataComponentInterpretation>;

/// All values of the whole mesh, on every rank.
struct Values {
  std::vector<std::string> nodal_names, point_names;
  std::vector<std::vector<double>> nodal, point;
};

template <int dim>
class Patches : public dealii::DataOutInterface<dim, dim>
{
public:
  std::vector<dealii::DataOutBase::Patch<dim, dim>> patches;
  std::vector<std::string> names;

protected:
  const std::vector<dealii::DataOutBase::Patch<dim, dim>> &
  get_patches() const override
  {
    return patches;
  }
  std::vector<std::string> get_dataset_names() const override { return names; }
  std::vector<Range> get_nonscalar_data_ranges() const override
  {
    return {{0,
             dim - 1,
             "displacement",
             Interpretation::component_is_part_of_vector}};
  }
};

/// Displacement, contact pressure and slip of the nodes.
void add_nodal_values(const Press &press, Values &values)
{
  const Mesh &mesh = press.mesh();
  const std::size_t count = mesh.nodes.size();
  for (unsigned c = 0; c < mesh.components(); ++c) {
    values.nodal_names.push_back("displacement");
    auto &u = values.nodal.emplace_back(count);
    for (std::size_t node = 0; node < count; ++node)
      u[node] = press.compact().state().positions[node][mesh.axis(c)] -
                mesh.nodes[node][mesh.axis(c)];
  }
  values.nodal_names.insert(values.nodal_names.end(),
                            {"contact_pressure", "contact_slip"});
  std::vector<double> pressure(count, 0.), slip(count, 0.);
  const auto &pairs = press.contact().pairs();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const PairForce &force = press.contact().accepted()[i];
    const double area = press.contact().area(i);
    if (area > 0)
      pressure[pairs[i].node] =
          std::max(pressure[pairs[i].node], force.normal / area);
    slip[pairs[i].node] = std::max(slip[pairs[i].node], force.slip);
  }
  values.nodal.push_back(std::move(pressure));
  values.nodal.push_back(std::move(slip));
}

/// Fields of all points that the state holds.
std::vector<PointField> fields_of(const Press &press)
{
  const bool ring = press.mesh().is_axisymmetric();
  std::vector<PointField> fields;
  const auto add = [&](const char *name, auto value) {
    PointField field{name, {}, {}};
    for (const Response &response : press.compact().state().responses)
      field.values.push_back(value(response));
    fields.push_back(std::move(field));
  };
  const auto stress = [&](const char *name, unsigned i, unsigned j) {
    add(name, [i, j](const Response &r) { return -r.stress[i][j]; });
  };
  stress(ring ? "stress_rr" : "stress_xx", 0, 0);
  stress(ring ? "stress_tt" : "stress_yy", 1, 1);
  stress("stress_zz", 2, 2);
  stress(ring ? "stress_rz" : "stress_xz", 0, 2);
  if (!ring) {
    stress("stress_xy", 0, 1);
    stress("stress_yz", 1, 2);
  }
  add("pressure", [](const Response &r) { return -trace(r.stress) / 3; });
  add("deviatoric_stress", [](const Response &r) {
    return std::sqrt(1.5) * dealii::deviator(r.stress).norm();
  });
  add("relative_density", [](const Response &r) { return r.relative_density; });
  std::size_t number = press.compact().point_share().begin;
  PointField point{"point", {}, {}}, cell{"cell", {}, {}};
  for (; point.values.size() < press.compact().point_share().size(); ++number) {
    point.values.push_back(static_cast<double>(number));
    cell.values.push_back(
        static_cast<double>(number / press.mesh().points_per_cell()));
  }
  fields.push_back(std::move(point));
  fields.push_back(std::move(cell));
  return fields;
}

/// Multilinear value at a corner of the part of a cell that belongs to a point.
template <int dim>
double corner_value(const Mesh &mesh,
                    const std::vector<double> &nodal,
                    std::size_t point,
                    unsigned corner)
{
  const unsigned n = mesh.nodes_per_cell();
  const unsigned *nodes = mesh.nodes_of_cell(point / n);
  const unsigned part = point % n;
  double value = 0;
  for (unsigned a = 0; a < n; ++a) {
    double weight = 1;
    for (int d = 0; d < dim; ++d) {
      const double x = 0.5 * ((part >> d & 1) + (corner >> d & 1));
      weight *= (a >> d & 1) != 0 ? x : 1 - x;
    }
    value += weight * nodal[nodes[a]];
  }
  return value;
}

template <int dim>
std::string vtu(const Press &press, const Values &values)
{
  const Mesh &mesh = press.mesh();
  std::vector<std::vector<double>> place(dim);
  for (int d = 0; d < dim; ++d)
    for (const auto &x : press.compact().state().positions)
      place[d].push_back(x[mesh.axis(d)]);
  Patches<dim> output;
  output.names = values.nodal_names;
  output.names.insert(
      output.names.end(), values.point_names.begin(), values.point_names.end());
  constexpr unsigned corners = 1u << dim;
  for (std::size_t point = 0; point < mesh.number_of_points(); ++point) {
    dealii::DataOutBase::Patch<dim, dim> patch;
    patch.patch_index = static_cast<unsigned>(point);
    patch.n_subdivisions = 1;
    patch.reference_cell = dealii::ReferenceCells::get_hypercube<dim>();
    patch.data.reinit(static_cast<unsigned>(output.names.size()), corners);
    for (unsigned corner = 0; corner < corners; ++corner) {
      for (int d = 0; d < dim; ++d)
        patch.vertices[corner][d] =
            corner_value<dim>(mesh, place[d], point, corner);
      unsigned row = 0;
      for (const auto &nodal : values.nodal)
        patch.data(row++, corner) =
            corner_value<dim>(mesh, nodal, point, corner);
      for (const auto &field : values.point)
        patch.data(row++, corner) = field[point];
    }
    output.patches.push_back(patch);
  }
  dealii::DataOutBase::VtkFlags flags;
  flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
  flags.print_date_and_time = false; // the same run writes the same file
  output.set_flags(flags);
  std::ostringstream text;
  output.write_vtu(text);
  return text.str();
}

std::string with_units(const std::string &vtu,
                       bool axisymmetric,
                       const std::vector<PointField> &extra)
{
  const std::string place =
      axisymmetric ? "Half section of a compact: x = r, y = z [m]; "
                     "stress_rr radial, tt hoop, zz axial."
                   : "A compact; z is the pressing axis [m].";
  std::string units =
      "<!-- " + place +
      " displacement [m] since the start;\n"
      "     stress_*, pressure, contact_pressure [Pa], compression positive; "
      "deviatoric_stress: von Mises [Pa];\n     contact_slip [m] in the last "
      "step; relative_density [-]. One part of a cell a material point; "
      "point and cell: their numbers.";
  for (const PointField &field : extra)
    if (!field.meaning.empty())
      units += "\n     " + field.name + " " + field.meaning + ".";
  units += " -->\n";
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
                   const Press &press,
                   const std::vector<PointField> &extra)
{
  Values values;
  add_nodal_values(press, values);
  std::vector<PointField> fields = fields_of(press);
  for (const PointField &field : extra) {
    if (field.values.size() != press.compact().point_share().size())
      throw std::invalid_argument("field '" + field.name +
                                  "' does not have one value a point");
    fields.push_back(field);
  }
  for (const PointField &field : fields) {
    values.point_names.push_back(field.name);
    values.point.push_back(press.compact().whole(field.values));
  }
  if (press.ranks().rank() != 0)
    return;
  const bool axisymmetric = press.mesh().is_axisymmetric();
  replace_file(
      file,
      with_units(axisymmetric ? vtu<2>(press, values) : vtu<3>(press, values),
                 axisymmetric,
                 extra));
}

std::vector<PointField> variable_fields(const MaterialPoints &points)
{
  std::vector<PointField> fields;
  for (const Variable &variable : points.variables())
    fields.push_back(
        {variable.name, {}, "[" + variable.unit + "] " + variable.meaning});
  std::vector<double> values(fields.size());
  for (std::size_t point = 0; point < points.size(); ++point) {
    points.variables_of(point, values);
    for (std::size_t i = 0; i < fields.size(); ++i)
      fields[i].values.push_back(values[i]);
  }
  return fields;
}
} // namespace tamp::fem
