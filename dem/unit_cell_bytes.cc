// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/unit_cell_bytes.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace tamp::dem
{
namespace
{
constexpr std::uint64_t mark = 0x324c4c4543504d54; // "TMPCELL2"

struct Writer {
  std::vector<char> &bytes;

  template <class T>
  void operator()(const T &value)
  {
    const char *begin = reinterpret_cast<const char *>(&value);
    bytes.insert(bytes.end(), begin, begin + sizeof(T));
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
  template <class T>
  void operator()(std::vector<T> &values)
  {
    std::uint64_t count;
    (*this)(count);
    if (count > bytes.size() / sizeof(T))
      throw std::runtime_error("unit cell: bytes are cut off");
    values.resize(count);
    if (count > 0)
      std::memcpy(static_cast<void *>(values.data()),
                  take(count * sizeof(T)),
                  count * sizeof(T));
  }

private:
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

/// Whether every index is that of a grain and every vector fits.
bool consistent(const UnitCell &cell)
{
  const std::size_t n = cell.size();
  const auto fits = [n](const Pair &pair) {
    return pair.first < pair.second && pair.second < n;
  };
  for (const ContactMemory &contact : cell.contacts)
    if (!fits(contact.pair))
      return false;
  for (const Pair &pair : cell.neighbours.pairs)
    if (!fits(pair))
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
  return n > 0 && cell.place.size() == n && none_or(cell.species.size(), n) &&
         none_or(cell.velocity.size(), n) && none_or(cell.spin.size(), n) &&
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
  if (!read.bytes.empty() || !consistent(cell))
    throw std::runtime_error("unit cell: bytes do not make up a cell");
  return cell;
}
} // namespace tamp::dem
