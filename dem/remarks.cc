// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
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
using Kind = Remark::Kind;

// Contacts of neighbours touch above this relative density: Harthong et al.
// (2009), Int. J. Solids Struct. 46:3357.
constexpr double densest_of_pairs = 0.82;
// MiDi (2004), Eur. Phys. J. E 14:341.
constexpr double largest_inertial_number = 1e-3;
// Diameters of the largest grain across the box; below about 2.3 nearest
// images fail.
constexpr double narrowest_box = 3;
// delta / R* and (a / R*)^2: the theory of small contacts ends here.
constexpr double largest_small_overlap = 0.1;

std::string four_digits(double value)
{
  std::ostringstream out;
  out.precision(4);
  out << value;
  return out.str();
}

/// The remark with the text "BEFORE value BETWEEN bound AFTER".
Remark remark(Remark result,
              const std::string &before,
              const std::string &between,
              const std::string &after)
{
  result.text = before + four_digits(result.value) + between +
                four_digits(result.bound) + after;
  return result;
}

/// Overlap over R* where contacts begin to yield: (pi p_y / (2 E*))^2 of
/// Thornton and Ning; 8 c^2 (p_y / E*)^2 of Storakers, where what unloading
/// gives back is the overlap itself; zero for other laws.
double yield_overlap(const ContactModel &model, const PairMaterial &pair)
{
  const double ratio = pair.limiting_pressure / pair.effective_modulus;
  switch (model.normal_law) {
  case NormalLaw::thornton_ning:
  case NormalLaw::thornton_ning_jkr:
  case NormalLaw::thornton_ning_adjusted:
    return std::pow(0.5 * std::numbers::pi * ratio, 2);
  case NormalLaw::storakers:
    return 8 * 1.43 * ratio * ratio;
  default:
    return 0;
  }
}

bool adhesive(const ContactModel &model)
{
  return model.normal_law == NormalLaw::jkr ||
         model.normal_law == NormalLaw::thornton_ning_jkr;
}

/// a / R* of spheres that nothing presses: the zero of JKR's force,
/// a^3 = 9 pi Gamma R*^2 / (2 E*). Source: see Jkr.
double radius_of_adhesion(const ContactModel &model,
                          const PairMaterial &pair,
                          double reduced_radius)
{
  return adhesive(model)
             ? std::cbrt(4.5 * std::numbers::pi * model.work_of_adhesion /
                         (pair.effective_modulus * reduced_radius))
             : 0;
}

/// Of each kind the worst over the pairs of materials that there are.
void judge_pairs(const UnitCell &cell, std::vector<Remark> &remarks)
{
  const std::vector<double> radius = smallest_radii(cell);
  const std::vector<GrainMaterial> materials = cell.materials_now();
  const auto keep = [&](const Remark &remark) {
    const auto same = std::ranges::find(remarks, remark.kind, &Remark::kind);
    if (same == remarks.end())
      remarks.push_back(remark);
    else if (worse(remark, *same))
      *same = remark;
  };
  for (std::size_t a = 0; a < radius.size(); ++a)
    for (std::size_t b = a; b < radius.size(); ++b)
      if (std::isfinite(radius[a] + radius[b]))
        for (const Remark &remark : judge_contacts(
                 cell.contact,
                 pair_material(materials[a], materials[b]),
                 radius[a] * radius[b] / (radius[a] + radius[b]),
                 radius.size() == 1
                     ? "contacts"
                     : "contacts of species " + std::to_string(a + 1) +
                           " and " + std::to_string(b + 1)))
          keep(remark);
}
} // namespace

bool about_a_state(Kind kind)
{
  return kind == Kind::beyond_pair_laws || kind == Kind::not_quasi_static ||
         kind == Kind::box_narrow;
}

bool worse(const Remark &first, const Remark &second)
{
  return std::abs(std::log(first.value / first.bound)) >
         std::abs(std::log(second.value / second.bound));
}

std::vector<Remark> judge_contacts(const ContactModel &model,
                                   const PairMaterial &pair,
                                   double reduced_radius,
                                   const std::string &name)
{
  std::vector<Remark> remarks;
  if (const double overlap = yield_overlap(model, pair);
      overlap > largest_small_overlap)
    remarks.push_back(remark(
        {Kind::yields_out_of_range, overlap, largest_small_overlap},
        name + " would yield at an overlap of ",
        " R* only, above ",
        " R*, beyond any small contact; lower the limiting contact pressure or "
        "raise Young's modulus"));
  const double most = std::sqrt(largest_small_overlap);
  if (const double radius = radius_of_adhesion(model, pair, reduced_radius);
      radius > most)
    remarks.push_back(
        remark({Kind::adhesion_flattens, radius, most},
               "adhesion alone gives " + name + " a radius of ",
               " R*, above ",
               " R*, beyond any small contact; lower the work of adhesion"));
  return remarks;
}

std::vector<Remark>
judge(const UnitCell &cell, const Driving &driving, double pressure)
{
  std::vector<Remark> remarks;
  if (const double density = cell.relative_density();
      density > densest_of_pairs && cell.contact.normal_law != NormalLaw::mdr)
    remarks.push_back(remark(
        {Kind::beyond_pair_laws, density, densest_of_pairs},
        "the relative density is ",
        "; above ",
        " contact laws of pairs lose accuracy and real powder is "
        "stiffer; press less far, or take the law mdr or a continuum law"));
  if (driving.method == Method::dynamics)
    if (const double number =
            measure_dynamics(cell, driving.dynamics, pressure).inertial_number;
        number > largest_inertial_number)
      remarks.push_back(
          remark({Kind::not_quasi_static, number, largest_inertial_number},
                 "not quasi-static: the inertial number is ",
                 ", above ",
                 "; lower the strain rate or the density scaling"));
  if (const double diameters =
          cell.box.smallest_width() / (2 * cell.largest_radius());
      diameters < narrowest_box)
    remarks.push_back(remark({Kind::box_narrow, diameters, narrowest_box},
                             "the cell is only ",
                             " of its largest grains wide; below ",
                             " it is soon too narrow for nearest images; use "
                             "more grains"));
  judge_pairs(cell, remarks);
  return remarks;
}
} // namespace tamp::dem
