// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/unit_cell_bytes.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace tamp::dem
{
namespace
{
constexpr std::uint64_t mark = 0x354c4c4543504d54; // "TMPCELL5"

// Records are written as they lie in memory, which must have no gaps: what is
// in them is no value. ContactModel has gaps.
static_assert(sizeof(PressureAtDensity) == 2 * sizeof(double));
static_assert(sizeof(Vector3) == 3 * sizeof(double));
static_assert(sizeof(ContactMemory) == sizeof(Pair) + 5 * sizeof(double));
static_assert(sizeof(EnergyAccount) == 5 * sizeof(double));

/// All parts of a material, in the order of the bytes.
template <class Material, class Visitor>
void visit_material(Material &material, Visitor &visit)
{
  visit(material.youngs_modulus);
  visit(material.poissons_ratio);
  visit(material.density);
  visit(material.limiting_pressure);
  visit(material.adjusted_pressures);
}

/// All parts of a contact model, in the order of the bytes.
template <class Model, class Visitor>
void visit_model(Model &model, Visitor &visit)
{
  visit(model.normal_law);
  visit(model.tangential_law);
  visit(model.rolling_law);
  visit(model.friction_coefficient);
  visit(model.work_of_adhesion);
  visit(model.rolling_friction_coefficient);
  visit(model.restitution_coefficient);
  visit(model.bulk_onset);
}

struct Writer {
  std::vector<char> &bytes;

  template <class T>
  void operator()(const T &value)
  {
    const char *begin = reinterpret_cast<const char *>(&value);
    bytes.insert(bytes.end(), begin, begin + sizeof(T));
  }
  void operator()(const ContactModel &model) { visit_model(model, *this); }
  void operator()(const std::vector<GrainMaterial> &materials)
  {
    (*this)(std::uint64_t(materials.size()));
    for (const GrainMaterial &material : materials)
      visit_material(material, *this);
  }
  template <class T>
  void operator()(const std::vector<T> &values)
  {
    (*this)(std::uint64_t(values.size()));
    const char *begin = reinterpret_cast<const char *>(values.data());
    bytes.insert(bytes.end(), begin, begin + values.size() * sizeof(T));
  }
};

struct Reader {
  std::span<const char> bytes;

  template <class T>
  void operator()(T &value)
  {
    std::memcpy(static_cast<void *>(&value), take(sizeof(T)), sizeof(T));
  }
  void operator()(ContactModel &model) { visit_model(model, *this); }
  void operator()(std::vector<GrainMaterial> &materials)
  {
    materials.assign(count_of(4 * sizeof(double)), {});
    for (GrainMaterial &material : materials)
      visit_material(material, *this);
  }
  template <class T>
  void operator()(std::vector<T> &values)
  {
    const std::uint64_t count = count_of(sizeof(T));
    values.resize(count);
    if (const std::size_t size = values.size() * sizeof(T); size > 0)
      std::memcpy(static_cast<void *>(values.data()), take(size), size);
  }

private:
  /// How many of these follow, each of `size` bytes or more.
  std::uint64_t count_of(std::size_t size)
  {
    std::uint64_t count;
    (*this)(count);
    if (count > bytes.size() / size)
      throw std::runtime_error("unit cell: bytes are cut off");
    return count;
  }
  const char *take(std::size_t count)
  {
    if (count > bytes.size())
      throw std::runtime_error("unit cell: bytes are cut off");
    const char *begin = bytes.data();
    bytes = bytes.subspan(count);
    return begin;
  }
};

/// All parts of a cell, in the order of the bytes.
template <class Cell, class Visitor>
void visit_parts(Cell &cell, Visitor &visit)
{
  visit(cell.materials);
  visit(cell.species);
  visit(cell.contact);
  visit(cell.box.h);
  visit(cell.reference_volume);
  visit(cell.radius);
  visit(cell.initial_radius);
  visit(cell.place);
  visit(cell.velocity);
  visit(cell.spin);
  visit(cell.contacts);
  visit(cell.more_memory);
  visit(cell.neighbours.pairs);
  visit(cell.neighbours.skin);
  visit(cell.neighbours.box);
  visit(cell.neighbours.place);
  visit(cell.last.log_stretch);
  visit(cell.last.motion);
  visit(cell.energy);
}

/// Whether the names are those of laws and the values physical.
bool physical(const UnitCell &cell)
{
  const ContactModel &model = cell.contact;
  const auto among = [](auto name, auto last) {
    return name >= decltype(name){} && name <= last;
  };
  if (!among(model.normal_law, NormalLaw::thornton_ning_adjusted) ||
      !among(model.tangential_law, TangentialLaw::mindlin_deresiewicz) ||
      !among(model.rolling_law, RollingLaw::epsd))
    return false;
  try {
    model.check();
    for (const GrainMaterial &material : cell.materials)
      material.check();
    check_adjusted(model, cell.materials);
  } catch (const std::invalid_argument &) {
    return false;
  }
  const auto finite = [](const auto &vector) { return vector.allFinite(); };
  const auto size = [](double r) { return r > 0 && std::isfinite(r); };
  return size(cell.box.volume()) && std::ranges::all_of(cell.radius, size) &&
         std::ranges::all_of(cell.initial_radius, size) &&
         std::ranges::all_of(cell.place, finite);
}

/// Whether the pairs are of two grains each, and sorted.
bool in_order(auto pair_of, const auto &values, std::size_t grains)
{
  const Pair *last = nullptr;
  for (const auto &value : values) {
    const Pair &pair = pair_of(value);
    if (pair.first >= pair.second || pair.second >= grains ||
        (last && !(*last < pair)))
      return false;
    last = &pair;
  }
  return true;
}

/// Whether every index is that of a grain and every vector fits.
bool consistent(const UnitCell &cell)
{
  const std::size_t n = cell.size();
  const auto itself = [](const Pair &pair) -> const Pair & { return pair; };
  const auto contact = [](const ContactMemory &memory) -> const Pair & {
    return memory.pair;
  };
  if (!in_order(contact, cell.contacts, n) ||
      !in_order(itself, cell.neighbours.pairs, n))
    return false;
  const auto none_or = [](std::size_t size, std::size_t wanted) {
    return size == 0 || size == wanted;
  };
  for (std::uint8_t species : cell.species)
    if (species >= cell.materials.size())
      return false;
  if (cell.materials.empty() ||
      cell.more_memory.size() != cell.contacts.size() * CellLaws(cell).more())
    return false;
  return n > 0 && cell.place.size() == n &&
         none_or(cell.initial_radius.size(), n) &&
         none_or(cell.species.size(), n) && none_or(cell.velocity.size(), n) &&
         none_or(cell.spin.size(), n) &&
         none_or(cell.neighbours.place.size(), n) &&
         none_or(cell.last.motion.size(), 6 * n);
}
} // namespace

void to_bytes(const UnitCell &cell, std::vector<char> &bytes)
{
  Writer write{bytes};
  write(mark);
  visit_parts(cell, write);
}

UnitCell from_bytes(std::span<const char> bytes)
{
  Reader read{bytes};
  std::uint64_t found;
  read(found);
  if (found != mark)
    throw std::runtime_error("unit cell: bytes do not begin as a cell does");
  UnitCell cell;
  visit_parts(cell, read);
  if (!read.bytes.empty() || !physical(cell) || !consistent(cell))
    throw std::runtime_error("unit cell: bytes do not make up a cell");
  return cell;
}
} // namespace tamp::dem
