// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/hdf5_image.h>

#include <algorithm>
#include <array>
#include <hdf5.h>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace tamp::coupling
{
namespace
{
/// Something of HDF5's that must be closed.
class Handle
{
public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Handle(Handle &&other) noexcept : id_(other.id_), close_(other.close_)
  {
    other.id_ = H5I_INVALID_HID;
  }
  Handle &operator=(Handle &&) = delete;
  ~Handle()
  {
    if (id_ >= 0)
      close_(id_);
  }
  operator hid_t() const { return id_; }
  bool good() const { return id_ >= 0; }

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// HDF5 prints no errors while this lives.
class Silence
{
public:
  Silence()
  {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  Silence(const Silence &) = delete;
  Silence &operator=(const Silence &) = delete;

private:
  H5E_auto2_t function_ = nullptr;
  void *data_ = nullptr;
};

void must(bool good, const char *deed)
{
  if (!good)
    throw std::runtime_error(std::string("HDF5 could not ") + deed);
}

/// Access to a file that lives in memory, not on a disk.
Handle access_in_memory()
{
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  must(access.good() && H5Pset_fapl_core(access, 1 << 16, false) >= 0,
       "prepare a file in memory");
  return access;
}

/// HDF5 tells open files apart by their names, though none is on a disk.
std::string name_of(const void *owner)
{
  return std::to_string(reinterpret_cast<std::uintptr_t>(owner));
}

// HDF5 leaves the first bytes of a file to its user.
constexpr std::size_t user_block = 512;

/// FNV-1a, 64 bits.
std::uint64_t checksum(std::span<const char> bytes)
{
  std::uint64_t sum = 14695981039346656037u;
  for (const char byte : bytes)
    sum = (sum ^ static_cast<unsigned char>(byte)) * 1099511628211u;
  return sum;
}

/// What stands at the beginning of a file.
std::string title(const std::string &format, std::span<const char> image)
{
  std::ostringstream text;
  text << format << ", HDF5 from byte " << user_block << " on, checksum "
       << std::hex << std::setw(16) << std::setfill('0') << checksum(image)
       << '\n';
  return text.str();
}

void add_unit(hid_t dataset, const std::string &unit)
{
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  must(H5Tset_size(type, unit.size()) >= 0, "write a unit");
  const Handle attribute(
      H5Acreate2(dataset, "unit", type, space, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  must(attribute.good() && H5Awrite(attribute, type, unit.c_str()) >= 0,
       "write a unit");
}
} // namespace

struct Hdf5Writer::Implementation {
  Silence silence;
  Handle file;

  Implementation() : file(create(this), H5Fclose)
  {
    must(file.good(), "start");
  }

  static hid_t create(const void *owner)
  {
    const Handle access = access_in_memory();
    return H5Fcreate(
        name_of(owner).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  }

  void write(const std::string &name,
             hid_t stored,
             hid_t given,
             const void *values,
             std::size_t count,
             std::size_t columns,
             const std::string &unit)
  {
    const std::array<hsize_t, 2> shape{count / columns, columns};
    const int rank = columns > 1 ? 2 : 1;
    const Handle space(H5Screate_simple(rank, shape.data(), nullptr), H5Sclose);
    const Handle folders(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    const Handle settings(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    must(H5Pset_create_intermediate_group(folders, 1) >= 0 &&
             H5Pset_obj_track_times(settings, false) >= 0,
         "prepare a dataset");
    const Handle dataset(
        H5Dcreate2(
            file, name.c_str(), stored, space, folders, settings, H5P_DEFAULT),
        H5Dclose);
    must(dataset.good(), "make a dataset");
    if (count > 0)
      must(H5Dwrite(dataset, given, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0,
           "write a dataset");
    if (!unit.empty())
      add_unit(dataset, unit);
  }
};

Hdf5Writer::Hdf5Writer() : implementation_(std::make_unique<Implementation>())
{
}
Hdf5Writer::~Hdf5Writer() = default;

void Hdf5Writer::numbers(const std::string &name,
                         const std::string &unit,
                         std::span<const double> values,
                         std::size_t columns)
{
  implementation_->write(name,
                         H5T_IEEE_F64LE,
                         H5T_NATIVE_DOUBLE,
                         values.data(),
                         values.size(),
                         columns,
                         unit);
}

void Hdf5Writer::integers(const std::string &name,
                          std::span<const std::uint32_t> values,
                          std::size_t columns)
{
  implementation_->write(name,
                         H5T_STD_U32LE,
                         H5T_NATIVE_UINT32,
                         values.data(),
                         values.size(),
                         columns,
                         "");
}

void Hdf5Writer::text(const std::string &name, const std::string &value)
{
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  must(H5Tset_size(type, std::max<std::size_t>(value.size(), 1)) >= 0,
       "write a text");
  implementation_->write(name, type, type, value.c_str(), 1, 1, "");
}

std::vector<char> Hdf5Writer::bytes(const std::string &format)
{
  const hid_t file = implementation_->file;
  must(H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0, "finish a file");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  must(size > 0, "finish a file");
  std::vector<char> bytes(user_block + static_cast<std::size_t>(size), ' ');
  const std::span<char> image = std::span(bytes).subspan(user_block);
  must(H5Fget_file_image(file, image.data(), image.size()) == size,
       "finish a file");
  const std::string text = title(format, image);
  must(text.size() <= user_block, "hold so long a name");
  std::ranges::copy(text, bytes.begin());
  return bytes;
}

struct Hdf5Reader::Implementation {
  Silence silence;
  Handle file;

  explicit Implementation(std::span<const char> bytes)
      : file(open(this, bytes), H5Fclose)
  {
    if (!file.good())
      throw std::invalid_argument("it is no HDF5 file");
  }

  static hid_t open(const void *owner, std::span<const char> bytes)
  {
    const Handle access = access_in_memory();
    // HDF5 takes a copy, in spite of the type.
    must(H5Pset_file_image(
             access, const_cast<char *>(bytes.data()), bytes.size()) >= 0,
         "look at a file");
    return H5Fopen(name_of(owner).c_str(), H5F_ACC_RDONLY, access);
  }

  [[noreturn]] static void complain(const std::string &name,
                                    const std::string &problem)
  {
    throw std::invalid_argument("its dataset '" + name + "' " + problem);
  }

  Handle open_dataset(const std::string &name) const
  {
    Handle dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!dataset.good())
      complain(name, "is missing or damaged");
    return dataset;
  }

  template <class T>
  std::vector<T> read(const std::string &name,
                      std::size_t columns,
                      H5T_class_t kind,
                      hid_t wanted) const
  {
    const Handle dataset = open_dataset(name);
    const Handle type(H5Dget_type(dataset), H5Tclose);
    const Handle space(H5Dget_space(dataset), H5Sclose);
    if (!type.good() || H5Tget_class(type) != kind ||
        H5Tget_size(type) != sizeof(T))
      complain(name, "is of another kind");
    std::array<hsize_t, 2> shape{0, 1};
    const int rank = columns > 1 ? 2 : 1;
    if (!space.good() || H5Sget_simple_extent_ndims(space) != rank ||
        H5Sget_simple_extent_dims(space, shape.data(), nullptr) != rank ||
        shape[1] != columns || shape[0] > largest_count)
      complain(name,
               "has another shape than rows of " + std::to_string(columns));
    std::vector<T> values(shape[0] * columns);
    if (!values.empty() &&
        H5Dread(dataset, wanted, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) <
            0)
      complain(name, "is damaged");
    return values;
  }

  static constexpr hsize_t largest_count = hsize_t(1) << 28;
};

Hdf5Reader::Hdf5Reader(std::span<const char> bytes, const std::string &format)
{
  if (!recognises(bytes, format))
    throw std::invalid_argument("it does not begin as a " + format);
  const std::string wanted =
      bytes.size() < user_block ? "" : title(format, bytes.subspan(user_block));
  if (wanted.empty() ||
      !std::equal(wanted.begin(), wanted.end(), bytes.begin()))
    throw std::invalid_argument(
        "it is damaged or incomplete: its checksum does not fit");
  implementation_ = std::make_unique<Implementation>(bytes.subspan(user_block));
}
Hdf5Reader::~Hdf5Reader() = default;

bool Hdf5Reader::recognises(std::span<const char> bytes,
                            const std::string &format)
{
  return bytes.size() >= format.size() &&
         std::equal(format.begin(), format.end(), bytes.begin());
}

bool Hdf5Reader::foreign(std::span<const char> bytes)
{
  constexpr std::string_view signature = "\211HDF\r\n\032\n";
  return bytes.size() >= signature.size() &&
         std::equal(signature.begin(), signature.end(), bytes.begin());
}

bool Hdf5Reader::has(const std::string &name) const
{
  return H5Lexists(implementation_->file, name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<double> Hdf5Reader::numbers(const std::string &name,
                                        std::size_t columns)
{
  return implementation_->read<double>(
      name, columns, H5T_FLOAT, H5T_NATIVE_DOUBLE);
}

std::vector<std::uint32_t> Hdf5Reader::integers(const std::string &name,
                                                std::size_t columns)
{
  return implementation_->read<std::uint32_t>(
      name, columns, H5T_INTEGER, H5T_NATIVE_UINT32);
}

std::string Hdf5Reader::text(const std::string &name)
{
  const Handle dataset = implementation_->open_dataset(name);
  const Handle type(H5Dget_type(dataset), H5Tclose);
  const Handle space(H5Dget_space(dataset), H5Sclose);
  if (!type.good() || H5Tget_class(type) != H5T_STRING ||
      H5Tis_variable_str(type) > 0 || H5Tget_size(type) > 4096 ||
      H5Sget_simple_extent_npoints(space) != 1)
    Implementation::complain(name, "is no text");
  std::string value(H5Tget_size(type), '\0');
  if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()) < 0)
    Implementation::complain(name, "is damaged");
  return value.substr(0, value.find('\0'));
}
} // namespace tamp::coupling
