// SPDX-License-Identifier: BSD-3-Clause
#include <tests/benchmark/peers/peer_cell.h>

#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace tamp::speed
{
namespace
{
constexpr double youngs_modulus = 70e6; // [Pa]
constexpr double poissons_ratio = 0.3;  // [-]
constexpr double density = 2650;        // [kg/m3]
} // namespace

double number(const std::string &text)
{
  double value = 0;
  const char *end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end)
    throw std::invalid_argument("'" + text + "' should be a number");
  return value;
}

dem::UnitCell read_peer_cell(const std::string &file, double friction)
{
  std::ifstream in(file);
  if (!in)
    throw std::invalid_argument("cannot read the packing '" + file + "'");
  dem::UnitCell cell;
  cell.materials = {{youngs_modulus, poissons_ratio, density}};
  cell.contact.normal_law = dem::NormalLaw::hertz;
  cell.contact.tangential_law = dem::TangentialLaw::mindlin;
  cell.contact.friction_coefficient = friction;
  dem::Vector3 edges = dem::Vector3::Zero();
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string mark, name;
    if (line.starts_with('#')) {
      words >> mark >> name;
      if (name == "L")
        words >> edges[0] >> edges[1] >> edges[2];
      continue;
    }
    dem::Vector3 x;
    double r = 0;
    if (words >> x[0] >> x[1] >> x[2] >> r) {
      cell.place.push_back(x.cwiseQuotient(edges));
      cell.radius.push_back(r);
    }
  }
  if (cell.size() == 0 || !(edges.minCoeff() > 0))
    throw std::invalid_argument(
        "'" + file +
        "' should hold a line '# L lx ly lz' and grains 'x y z r'");
  cell.box.h = edges.asDiagonal();
  cell.reference_volume = cell.box.volume();
  return cell;
}
} // namespace tamp::speed
