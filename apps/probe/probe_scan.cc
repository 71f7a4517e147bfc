// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/units.h>
#include <apps/output/probe_columns.h>
#include <apps/probe/probe_scan.h>
#include <coupling/unit_cell_points.h>
#include <coupling/work_sharing.h>
#include <fem/stress_search.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <numeric>
#include <set>
#include <utility>

namespace tamp::apps
{
namespace
{
using fem::BranchKind;

/// A branch that every density has.
struct PlannedBranch {
  BranchKind kind;
  double share; ///< of the reached pressure [-]
};

std::vector<PlannedBranch> planned(const ScanSettings &settings)
{
  std::vector<PlannedBranch> plan;
  for (const auto &[kind, shares] :
       {std::pair(BranchKind::compression, &settings.compression_shares),
        std::pair(BranchKind::extension, &settings.extension_shares),
        std::pair(BranchKind::triaxial, &settings.triaxial_shares),
        std::pair(BranchKind::isotropic, &settings.isotropic_shares),
        std::pair(BranchKind::uniaxial, &settings.uniaxial_shares)})
    for (const double share : *shares)
      plan.push_back({kind, share});
  return plan;
}

std::vector<std::string> remarks(const ScanSettings &settings)
{
  std::vector<std::string> lines{
      "compression is positive; criterion 0: irreversible strain of " +
          fmt::format("{:g}", settings.strain_offset) +
          ", 1: plastic work per volume of " +
          fmt::format("{:g}", settings.plastic_work) +
          " times the reached pressure, 2: peak or critical state",
      "branches start from a copy of the state reached, unloaded to an "
      "isotropic stress"};
  const auto plan = planned(settings);
  for (std::size_t i = 0; i < plan.size(); ++i)
    lines.push_back(
        fmt::format("branch {}: unloaded to {:g} % of the reached pressure, "
                    "then {}",
                    i + 1,
                    100 * plan[i].share,
                    fem::words_of(plan[i].kind)));
  return lines;
}
} // namespace

/// The state of a listed density, and what is known of it.
struct ProbeScan::Reached {
  double density = 0, pressure = 0, deviatoric_stress = 0;
  std::vector<char> state;
  std::vector<fem::MeasuredModuli> moduli; ///< there, and at each share
};

struct ProbeScan::Branch {
  PlannedBranch plan;
  std::vector<char> state; ///< where it begins; none: it could not be unloaded
  fem::BranchEnd end;
};

ProbeScan::ProbeScan(RunSession &session,
                     const coupling::Material &material,
                     unsigned replica)
    : session_(session), settings_(session.input().scan), material_(material),
      replica_(replica)
{
  if (!settings_.on() || session.resumes())
    return;
  const auto folder = session.folder().path();
  yield_.emplace(folder / "yield.csv", yield_header(), remarks(settings_));
  moduli_.emplace(folder / "moduli.csv",
                  moduli_header(),
                  std::vector<std::string>{
                      "compression is positive; unloaded and loaded again by "
                      "strains of " +
                      fmt::format("{:g}", settings_.modulus_strain)});
}

void ProbeScan::take(const fem::PathRecord &record)
{
  if (next_ >= settings_.densities.size())
    return;
  const double density = record.response.relative_density;
  if (record.step == 0 && settings_.densities[next_] <= density)
    throw InputError(fmt::format(
        "Scan/Densities: {:g} is not above the relative density of the powder "
        "at the start, {:.4g}",
        settings_.densities[next_],
        density));
  for (; next_ < settings_.densities.size() &&
         settings_.densities[next_] <= density;
       ++next_)
    scan(settings_.densities[next_], record);
  before_.clear();
  material_.points->pack(0, before_);
  density_before_ = density;
  F_before_ = record.F;
}

void ProbeScan::pack(std::vector<char> &bytes) const
{
  if (!settings_.on())
    return;
  for (const auto &file : {&yield_, &moduli_}) {
    (*file)->sync();
    fem::append_state(bytes, (*file)->size());
  }
  fem::append_state(bytes, next_);
  fem::append_state(bytes, density_before_);
  fem::append_state(bytes, F_before_);
  fem::append_state(bytes, points_);
  fem::append_state(bytes, lost_);
}

void ProbeScan::go_on(fem::StateBytes &stored)
{
  if (!settings_.on())
    return;
  std::uint64_t yield_size = 0, moduli_size = 0;
  stored.take(yield_size);
  stored.take(moduli_size);
  stored.take(next_);
  stored.take(density_before_);
  stored.take(F_before_);
  stored.take(points_);
  stored.take(lost_);
  const auto folder = session_.folder().path();
  yield_.emplace(folder / "yield.csv", yield_header().size(), yield_size);
  moduli_.emplace(folder / "moduli.csv", moduli_header().size(), moduli_size);
  before_.clear();
  material_.points->pack(0, before_);
}

void ProbeScan::give() const
{
  if (!settings_.on())
    return;
  session_.result("scanned_densities[-]", static_cast<double>(next_));
  session_.result("yield_points[-]", points_);
  if (next_ < settings_.densities.size())
    session_.warn(fmt::format("Scan/Densities: the path did not come to {:g}",
                              settings_.densities[next_]));
  if (lost_ > 0)
    session_.warn(fmt::format("{:g} branches of the scan did not converge, or "
                              "found no elastic state; what they had found "
                              "before is kept",
                              lost_));
}

coupling::Material ProbeScan::copy_at(std::span<const char> state) const
{
  coupling::Material copy =
      coupling::copy_point(session_.input().material, material_);
  copy.points->unpack(0, state);
  return copy;
}

fem::BranchDriving ProbeScan::driving(const coupling::Material &point) const
{
  fem::BranchDriving driving;
  driving.increment = settings_.increment;
  driving.coarse_increment = 5 * settings_.increment;
  driving.largest_strain = settings_.largest_strain;
  driving.stress_tolerance = session_.input().stress_tolerance;
  if (point.cells)
    driving.turn = [cells = point.cells] { cells->turn(); };
  return driving;
}

// A part of the last increment, in its direction, that ends at the density.
ProbeScan::Reached ProbeScan::reach(double density,
                                    const fem::PathRecord &record) const
{
  Reached reached;
  reached.density = density;
  coupling::Material point = copy_at(before_);
  const double whole =
      std::log(record.response.relative_density / density_before_);
  const double share = std::log(density / density_before_) / whole;
  const auto split =
      fem::path::left_split(fem::path::increment(record.F, F_before_));
  fem::path::Six part = split.strain;
  for (double &value : part)
    value *= share;
  const auto take = [&](const fem::PathRecord &end) {
    const auto &stress = end.response.stress;
    reached.pressure = -trace(stress) / 3;
    reached.deviatoric_stress = std::sqrt(1.5) * deviator(stress).norm();
  };
  const bool there =
      fem::drive_increments(*point.points, {fem::path::stretch(part)}, take) ==
      fem::PathEnd::finished;
  if (!there || !(reached.pressure > 0))
    return reached;
  point.points->pack(0, reached.state);
  const auto turn = driving(point).turn;
  if (const auto moduli =
          measure_moduli(*point.points, settings_.modulus_strain, turn);
      moduli && moduli->bulk > 0 && moduli->shear > 0)
    reached.moduli.push_back(*moduli);
  else
    reached.state.clear();
  return reached;
}

// Unloads the point once, from share to share, and measures moduli there.
std::vector<ProbeScan::Branch> ProbeScan::branches_of(Reached &reached)
{
  std::vector<Branch> branches;
  std::set<double, std::greater<>> shares;
  for (const PlannedBranch &plan : planned(settings_)) {
    branches.push_back({plan, {}, {}});
    shares.insert(plan.share);
  }
  const coupling::Material point = copy_at(reached.state);
  const fem::BranchDriving how = driving(point);
  for (const double share : shares) {
    if (fem::unload_to(*point.points, share * reached.pressure, how) !=
        fem::PathEnd::finished)
      break;
    const auto moduli =
        measure_moduli(*point.points, settings_.modulus_strain, how.turn);
    if (!moduli || !(moduli->bulk > 0 && moduli->shear > 0))
      break;
    reached.moduli.push_back(*moduli);
    std::vector<char> state;
    point.points->pack(0, state);
    for (Branch &branch : branches)
      if (branch.plan.share >= share && branch.plan.share <= share)
        branch.state = state;
  }
  return branches;
}

void ProbeScan::drive(const Reached &reached, std::vector<Branch> &branches)
{
  const fem::ModuliOverPressure moduli(reached.moduli);
  const fem::YieldLimits limits{settings_.strain_offset,
                                settings_.plastic_work * reached.pressure};
  std::vector<std::size_t> order(branches.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  coupling::share_work(order, session_.threads(), [&](std::size_t i) {
    Branch &branch = branches[i];
    if (branch.state.empty())
      return;
    const coupling::Material point = copy_at(branch.state);
    branch.end = fem::drive_branch(
        *point.points, branch.plan.kind, limits, moduli, driving(point));
  });
}

void ProbeScan::scan(double density, const fem::PathRecord &record)
{
  Reached reached = reach(density, record);
  if (reached.state.empty()) {
    ++lost_;
    return;
  }
  write_moduli(density, reached.moduli[0]);
  std::vector<Branch> branches = branches_of(reached);
  drive(reached, branches);
  for (std::size_t i = 0; i < branches.size(); ++i) {
    const Branch &branch = branches[i];
    lost_ += branch.state.empty() || branch.end.end != fem::PathEnd::finished
                 ? 1
                 : 0;
    for (const fem::YieldPoint &point : branch.end.points) {
      ++points_;
      yield_->write(std::vector<double>{static_cast<double>(replica_),
                                        density,
                                        reached.pressure,
                                        reached.deviatoric_stress,
                                        static_cast<double>(i + 1),
                                        static_cast<double>(point.criterion),
                                        point.pressure,
                                        point.deviatoric_stress,
                                        point.plastic_volumetric_strain,
                                        point.plastic_shear_strain});
    }
  }
  session_.log().detail(fmt::format("scanned relative density {:g}: {:.4g} MPa",
                                    density,
                                    reached.pressure / 1e6));
}

void ProbeScan::write_moduli(double density, const fem::MeasuredModuli &moduli)
{
  moduli_->write(std::vector<double>{static_cast<double>(replica_),
                                     density,
                                     moduli.pressure,
                                     moduli.bulk,
                                     moduli.shear,
                                     moduli.youngs_modulus(),
                                     moduli.poissons_ratio()});
}
} // namespace tamp::apps
