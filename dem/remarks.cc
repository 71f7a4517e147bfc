// SPDX-License-Identifier: BSD-3-Clause
#include <dem/dynamics.h>
#include <dem/remarks.h>
#include <dem/unit_cell.h>

#include <algorithm>
#include <cmath>
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
  return remarks;
}
} // namespace tamp::dem
