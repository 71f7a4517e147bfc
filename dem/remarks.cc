// SPDX-License-Identifier: BSD-3-Clause
#include <dem/dynamics.h>
#include <dem/remarks.h>
#include <dem/unit_cell.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

namespace tamp::dem
{
namespace
{
// Contacts of neighbours touch above this relative density: Harthong et al.
// (2009), Int. J. Solids Struct. 46:3357.
constexpr double densest_of_pairs = 0.82;
// MiDi (2004), Eur. Phys. J. E 14:341.
constexpr double largest_inertial_number = 1e-3;
// Diameters of the largest grain across the box; below about 2.3 nearest
// images fail.
constexpr double narrowest_box = 3;
// delta_y / R*: the theory of small contacts ends here.
constexpr double largest_yield_overlap = 0.1;
// p_y / p_a, see AdhesiveYield: below 0.45 cycles gain energy.
constexpr double least_yield_over_adhesion = 0.5;

template <class... Parts>
std::string text(const Parts &...parts)
{
  std::ostringstream out;
  out.precision(3);
  (out << ... << parts);
  return out.str();
}

/// delta_y / R* of the hardest material; zero where nothing yields.
double yield_overlap(const UnitCell &cell)
{
  double largest = 0;
  if (cell.contact.normal_law == NormalLaw::thornton_ning ||
      cell.contact.normal_law == NormalLaw::thornton_ning_jkr)
    for (const GrainMaterial &material : cell.materials) {
      const PairMaterial pair = pair_material(material, material);
      const double root = std::numbers::pi * pair.limiting_pressure /
                          (2 * pair.effective_modulus);
      largest = std::max(largest, root * root);
    }
  return largest;
}
/// Smallest p_y / p_a of the materials under adhesion, where
/// p_a = (2 E*^2 Gamma / (pi^2 R*))^(1/3) for the smallest grains; infinite
/// for other laws.
double yield_over_adhesion(const UnitCell &cell)
{
  double smallest = std::numeric_limits<double>::infinity();
  if (cell.contact.normal_law == NormalLaw::thornton_ning_jkr)
    for (const GrainMaterial &material : cell.materials) {
      const PairMaterial pair = pair_material(material, material);
      const double pressure = std::cbrt(
          2 * pair.effective_modulus * pair.effective_modulus *
          cell.contact.work_of_adhesion /
          (std::numbers::pi * std::numbers::pi * 0.5 * cell.smallest_radius()));
      smallest = std::min(smallest, pair.limiting_pressure / pressure);
    }
  return smallest;
}
} // namespace

std::vector<Remark>
judge(const UnitCell &cell, const Driving &driving, const Matrix3 &stress)
{
  using Kind = Remark::Kind;
  std::vector<Remark> remarks;
  if (const double density = cell.relative_density();
      density > densest_of_pairs && cell.contact.normal_law != NormalLaw::mdr)
    remarks.push_back({Kind::beyond_pair_laws,
                       text("contact laws of pairs lose accuracy above a "
                            "relative density of about ",
                            densest_of_pairs,
                            "; it is ",
                            density)});
  if (driving.method == Method::dynamics) {
    const double number =
        measure_dynamics(cell, driving.dynamics, -stress.trace() / 3)
            .inertial_number;
    if (number > largest_inertial_number)
      remarks.push_back({Kind::not_quasi_static,
                         text("not quasi-static: inertial number ",
                              number,
                              " above ",
                              largest_inertial_number,
                              "; lower the strain rate or the density "
                              "scaling")});
  }
  if (const double diameters =
          cell.box.smallest_width() / (2 * cell.largest_radius());
      diameters < narrowest_box)
    remarks.push_back({Kind::box_narrow,
                       text("the cell is only ",
                            diameters,
                            " of its largest grains wide and will soon be too "
                            "narrow for nearest images; use more grains")});
  if (const double overlap = yield_overlap(cell);
      overlap > largest_yield_overlap)
    remarks.push_back({Kind::yields_out_of_range,
                       text("contacts would yield at an overlap of ",
                            overlap,
                            " R* only, beyond any small contact; the limiting "
                            "contact pressure is too high for Young's "
                            "modulus")});
  if (const double ratio = yield_over_adhesion(cell);
      ratio < least_yield_over_adhesion)
    remarks.push_back({Kind::adhesion_out_of_range,
                       text("the limiting contact pressure is only ",
                            ratio,
                            " of the pressure by which adhesion pulls the "
                            "smallest grains together, below ",
                            least_yield_over_adhesion,
                            " the law of plastic contacts with adhesion gains "
                            "energy")});
  return remarks;
}
} // namespace tamp::dem
