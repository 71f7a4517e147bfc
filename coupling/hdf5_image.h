// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_hdf5_image_h
#define coupling_hdf5_image_h

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tamp::coupling
{
/// The bytes of an HDF5 file that is being made in memory. The same content
/// gives the same bytes. Not for two threads at once, as HDF5 itself.
class Hdf5Writer
{
public:
  Hdf5Writer();
  ~Hdf5Writer();

  /// A dataset of `values` in rows of `columns`, with its unit; folders
  /// in its name are made.
  void numbers(const std::string &name,
               const std::string &unit,
               std::span<const double> values,
               std::size_t columns = 1);
  void integers(const std::string &name,
                std::span<const std::uint32_t> values,
                std::size_t columns = 1);
  void text(const std::string &name, const std::string &value);
  /// The whole file. Its first line says what it is, `format`, and has a
  /// checksum of all that follows; programs that know HDF5 pass over it.
  std::vector<char> bytes(const std::string &format);

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Reads what Hdf5Writer writes. All functions throw std::invalid_argument
/// naming the dataset that is missing, damaged, or of another kind or shape.
class Hdf5Reader
{
public:
  /// Throws also if the bytes are not a whole file of this format, to the bit.
  Hdf5Reader(std::span<const char> bytes, const std::string &format);
  ~Hdf5Reader();

  /// Whether a file begins as one of this format.
  static bool recognises(std::span<const char> bytes,
                         const std::string &format);
  /// Whether it is an HDF5 file that another program made.
  static bool foreign(std::span<const char> bytes);
  /// Whether there is a dataset of this name in a folder that there is.
  bool has(const std::string &name) const;
  std::vector<double> numbers(const std::string &name, std::size_t columns = 1);
  std::vector<std::uint32_t> integers(const std::string &name,
                                      std::size_t columns = 1);
  std::string text(const std::string &name);

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};
} // namespace tamp::coupling

#endif
