// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/hdf5_image.h>
#include <coupling/packing_file.h>
#include <coupling/packing_text.h>
#include <dem/law_names.h>
#include <dem/unit_cell_bytes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

namespace tamp::coupling
{
namespace
{
using dem::ContactMemory;
using dem::UnitCell;
using dem::Vector3;

constexpr const char *format = "tamp packing";
constexpr std::uint32_t version = 3;

/// Numbers that lie one after the other, as a view.
std::span<const double> flat(const std::vector<Vector3> &vectors)
{
  static_assert(sizeof(Vector3) == 3 * sizeof(double));
  return {reinterpret_cast<const double *>(vectors.data()), 3 * vectors.size()};
}

/// What a material is described by, with names and units.
struct MaterialColumn {
  const char *name, *unit;
  double dem::GrainMaterial::*value;
};
constexpr std::array material_columns{
    MaterialColumn{"youngs_modulus", "Pa", &dem::GrainMaterial::youngs_modulus},
    MaterialColumn{"poissons_ratio", "-", &dem::GrainMaterial::poissons_ratio},
    MaterialColumn{"density", "kg/m3", &dem::GrainMaterial::density},
    MaterialColumn{
        "limiting_pressure", "Pa", &dem::GrainMaterial::limiting_pressure}};
constexpr const char *adjusted_pressures = "adjusted_pressures";

/// Writes the parts of a cell. A cell is read by the same calls, see Source.
class Sink
{
public:
  std::vector<char> bytes() { return out_.bytes(format); }

  void number(const char *name, const char *unit, const double &value)
  {
    out_.numbers(name, unit, {&value, 1});
  }
  void matrix(const char *name, const char *unit, const dem::Matrix3 &value)
  {
    const dem::Matrix3 rows = value.transpose(); // stored row by row
    out_.numbers(name, unit, {rows.data(), 9}, 3);
  }
  void
  numbers(const char *name, const char *unit, const std::vector<double> &values)
  {
    out_.numbers(name, unit, values);
  }
  void later_number(const char *name, const char *unit, const double &value)
  {
    number(name, unit, value);
  }
  void later_numbers(const char *name,
                     const char *unit,
                     const std::vector<double> &values)
  {
    numbers(name, unit, values);
  }
  void vectors(const char *name,
               const char *unit,
               const std::vector<Vector3> &values)
  {
    out_.numbers(name, unit, flat(values), 3);
  }
  void materials(const std::string &folder,
                 const std::vector<dem::GrainMaterial> &materials)
  {
    for (const auto &[name, unit, value] : material_columns) {
      std::vector<double> column;
      for (const dem::GrainMaterial &material : materials)
        column.push_back(material.*value);
      out_.numbers(folder + name, unit, column);
    }
    std::vector<double> adjusted; // material, density, pressure
    for (std::size_t k = 0; k < materials.size(); ++k)
      for (const auto &[density, pressure] : materials[k].adjusted_pressures)
        adjusted.insert(adjusted.end(), {double(k), density, pressure});
    out_.numbers(folder + adjusted_pressures, "-, -, Pa", adjusted, 3);
  }
  void species(const char *name, const std::vector<std::uint8_t> &species)
  {
    out_.integers(name,
                  std::vector<std::uint32_t>(species.begin(), species.end()));
  }
  void pairs(const char *name, const std::vector<dem::Pair> &pairs)
  {
    std::vector<std::uint32_t> values;
    for (const dem::Pair &pair : pairs)
      values.insert(values.end(), {pair.first, pair.second});
    out_.integers(name, values, 2);
  }
  template <std::size_t n, class Choice>
  void choice(const char *name,
              const std::array<const char *, n> &names,
              Choice value)
  {
    out_.text(name, names.at(static_cast<std::size_t>(value)));
  }
  void version_of_file() { out_.integers("/version", {&version, 1}); }

private:
  Hdf5Writer out_;
};

/// Reads the parts of a cell.
class Source
{
public:
  explicit Source(std::span<const char> bytes) : in_(bytes, format) {}

  void number(const char *name, const char *, double &value)
  {
    value = sized(in_.numbers(name), 1, name)[0];
  }
  void matrix(const char *name, const char *, dem::Matrix3 &value)
  {
    const auto rows = sized(in_.numbers(name, 3), 9, name);
    value = Eigen::Map<const dem::Matrix3>(rows.data()).transpose();
  }
  /// Files of earlier versions are without; then the value stays.
  void later_number(const char *name, const char *unit, double &value)
  {
    if (in_.has(name))
      number(name, unit, value);
  }
  void
  later_numbers(const char *name, const char *unit, std::vector<double> &values)
  {
    if (in_.has(name))
      numbers(name, unit, values);
  }
  void numbers(const char *name, const char *, std::vector<double> &values)
  {
    values = in_.numbers(name);
  }
  void vectors(const char *name, const char *, std::vector<Vector3> &values)
  {
    const std::vector<double> found = in_.numbers(name, 3);
    values.clear();
    for (std::size_t k = 0; k < found.size(); k += 3)
      values.emplace_back(found[k], found[k + 1], found[k + 2]);
  }
  void materials(const std::string &folder,
                 std::vector<dem::GrainMaterial> &materials)
  {
    materials.clear();
    for (const auto &[name, unit, value] : material_columns) {
      const std::vector<double> column = in_.numbers(folder + name);
      if (materials.empty())
        materials.resize(column.size());
      sized(column, materials.size(), folder + name);
      for (std::size_t k = 0; k < column.size(); ++k)
        materials[k].*value = column[k];
    }
    if (!in_.has(folder + adjusted_pressures))
      return;
    const auto rows = in_.numbers(folder + adjusted_pressures, 3);
    for (std::size_t k = 0; k < rows.size(); k += 3) {
      if (!(rows[k] >= 0 && rows[k] < double(materials.size())))
        throw std::invalid_argument("an adjusted pressure is of no material");
      materials[std::size_t(rows[k])].adjusted_pressures.push_back(
          {rows[k + 1], rows[k + 2]});
    }
  }
  void species(const char *name, std::vector<std::uint8_t> &species)
  {
    const auto found = in_.integers(name);
    if (std::ranges::any_of(found, [](auto value) { return value > 255; }))
      throw std::invalid_argument("it has more than 256 species");
    species.assign(found.begin(), found.end());
  }
  void pairs(const char *name, std::vector<dem::Pair> &pairs)
  {
    const std::vector<std::uint32_t> found = in_.integers(name, 2);
    pairs.clear();
    for (std::size_t k = 0; k < found.size(); k += 2)
      pairs.push_back({found[k], found[k + 1]});
  }
  template <std::size_t n, class Choice>
  void choice(const char *name,
              const std::array<const char *, n> &names,
              Choice &value)
  {
    const std::string found = in_.text(name);
    const auto at = std::ranges::find(names, found);
    if (at == names.end())
      throw std::invalid_argument("its '" + std::string(name) + "' is '" +
                                  found + "', which is not in this version");
    value = static_cast<Choice>(at - names.begin());
  }
  void version_of_file()
  {
    const auto found = sized(in_.integers("/version"), 1, "/version")[0];
    if (found < 1 || found > version)
      throw std::invalid_argument("its version is " + std::to_string(found) +
                                  "; this program reads versions 1 to " +
                                  std::to_string(version));
  }

private:
  template <class Values>
  static Values sized(Values values, std::size_t size, const std::string &name)
  {
    if (values.size() != size)
      throw std::invalid_argument("its dataset '" + name + "' has " +
                                  std::to_string(values.size()) +
                                  " values, not " + std::to_string(size));
    return values;
  }

  Hdf5Reader in_;
};

/// The memory of contacts as columns.
struct ContactColumns {
  std::vector<dem::Pair> pair;
  std::vector<Vector3> tangential_force;
  std::vector<double> largest_overlap, contact_radius;

  explicit ContactColumns(const std::vector<ContactMemory> &contacts)
  {
    for (const ContactMemory &contact : contacts) {
      pair.push_back(contact.pair);
      tangential_force.push_back(contact.tangential_force);
      largest_overlap.push_back(contact.largest_overlap);
      contact_radius.push_back(contact.contact_radius);
    }
  }
  std::vector<ContactMemory> contacts() const
  {
    const std::size_t n = pair.size();
    if (tangential_force.size() != n || largest_overlap.size() != n ||
        contact_radius.size() != n)
      throw std::invalid_argument("its contacts have columns of other lengths");
    std::vector<ContactMemory> contacts(n);
    for (std::size_t k = 0; k < n; ++k)
      contacts[k] = {
          pair[k], tangential_force[k], largest_overlap[k], contact_radius[k]};
    return contacts;
  }
};

template <class File, class Cell, class Columns>
void visit_parts(File &file, Cell &cell, Columns &contacts)
{
  file.version_of_file();
  file.materials("/materials/", cell.materials);
  auto &law = cell.contact;
  file.choice(
      "/contact_model/normal_law", dem::normal_law_names, law.normal_law);
  file.choice("/contact_model/tangential_law",
              dem::tangential_law_names,
              law.tangential_law);
  file.number(
      "/contact_model/friction_coefficient", "-", law.friction_coefficient);
  file.choice(
      "/contact_model/rolling_law", dem::rolling_law_names, law.rolling_law);
  file.number("/contact_model/work_of_adhesion", "J/m2", law.work_of_adhesion);
  file.number("/contact_model/rolling_friction_coefficient",
              "-",
              law.rolling_friction_coefficient);
  file.number("/contact_model/restitution_coefficient",
              "-",
              law.restitution_coefficient);
  file.later_number("/contact_model/bulk_onset", "-", law.bulk_onset);
  file.matrix("/box", "m", cell.box.h);
  file.number("/reference_volume", "m3", cell.reference_volume);
  file.numbers("/grains/radius", "m", cell.radius);
  file.later_numbers("/grains/initial_radius", "m", cell.initial_radius);
  file.species("/grains/species", cell.species);
  file.vectors("/grains/place", "-", cell.place);
  file.vectors("/grains/velocity", "m/s", cell.velocity);
  file.vectors("/grains/spin", "rad/s", cell.spin);
  file.pairs("/contacts/pair", contacts.pair);
  file.vectors("/contacts/tangential_force", "N", contacts.tangential_force);
  file.numbers("/contacts/largest_overlap", "m", contacts.largest_overlap);
  file.numbers("/contacts/contact_radius", "m", contacts.contact_radius);
  file.numbers("/contacts/more_memory", "", cell.more_memory);
  auto &near = cell.neighbours;
  file.pairs("/neighbours/pair", near.pairs);
  file.number("/neighbours/skin", "m", near.skin);
  file.matrix("/neighbours/box", "m", near.box);
  file.vectors("/neighbours/place", "-", near.place);
  file.matrix("/last_motion/log_stretch", "-", cell.last.log_stretch);
  file.numbers("/last_motion/motion", "m", cell.last.motion);
  auto &energy = cell.energy;
  file.number("/energy/work", "J", energy.work);
  file.number("/energy/plastic_dissipation", "J", energy.plastic_dissipation);
  file.number("/energy/friction_dissipation", "J", energy.friction_dissipation);
  file.number("/energy/damping_dissipation", "J", energy.damping_dissipation);
  file.later_number(
      "/energy/adhesion_dissipation", "J", energy.adhesion_dissipation);
}

/// Throws std::invalid_argument unless the parts make up a cell that can be.
void check_cell(const UnitCell &cell)
{
  std::vector<char> bytes;
  to_bytes(cell, bytes);
  try {
    (void)dem::from_bytes(bytes); // judges whether all parts fit together
  } catch (const std::runtime_error &) {
    throw std::invalid_argument("its parts do not fit together");
  }
  for (const dem::GrainMaterial &material : cell.materials)
    material.check();
  cell.contact.check();
  if (!(cell.box.volume() > 0) || !(cell.reference_volume > 0))
    throw std::invalid_argument("its box has no volume");
  const auto positive = [](double r) { return std::isfinite(r) && r > 0; };
  if (!std::ranges::all_of(cell.radius, positive))
    throw std::invalid_argument("a radius is not positive");
  if (!std::ranges::all_of(cell.place, &Vector3::allFinite))
    throw std::invalid_argument("a place is not a number");
}

UnitCell packing_from_hdf5(std::span<const char> bytes)
{
  Source source(bytes);
  UnitCell cell;
  ContactColumns contacts({});
  visit_parts(source, cell, contacts);
  cell.contacts = contacts.contacts();
  check_cell(cell);
  return cell;
}
} // namespace

void write_packing(const UnitCell &cell, const std::filesystem::path &file)
{
  Sink sink;
  const ContactColumns contacts(cell.contacts);
  visit_parts(sink, cell, contacts);
  write_whole_file(file, sink.bytes());
}

void write_packing_text(const UnitCell &cell, const std::filesystem::path &file)
{
  write_whole_file(file, packing_to_text(cell));
}

UnitCell read_packing(const std::filesystem::path &file)
{
  const std::vector<char> bytes = read_whole_file(file);
  if (Hdf5Reader::foreign(bytes))
    throw std::invalid_argument(file.string() +
                                ": it is an HDF5 file of another program, "
                                "which holds no packing that can be read");
  if (!Hdf5Reader::recognises(bytes, format))
    return packing_from_text({bytes.begin(), bytes.end()}, file.string());
  try {
    return packing_from_hdf5(bytes);
  } catch (const std::invalid_argument &error) {
    throw std::invalid_argument(
        file.string() + ": no packing can be read from it: " + error.what());
  }
}
} // namespace tamp::coupling
