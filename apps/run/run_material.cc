// SPDX-License-Identifier: BSD-3-Clause
#include <apps/run/run_material.h>
#include <coupling/whole_file.h>
#include <fem/laws/cap_remarks.h>

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdexcept>
#include <vector>

namespace tamp::apps
{
namespace
{
// Cells packed below this pressure may collapse in the first steps.
constexpr double safe_start_pressure = 0.5e6;
} // namespace

std::string adhesion_doubt(const dem::ContactModel &model)
{
  const bool may = model.normal_law == dem::NormalLaw::jkr ||
                   model.normal_law == dem::NormalLaw::thornton_ning_jkr;
  if (may && !model.adheres())
    return "Contact/Work of adhesion is 0: the normal law is that without "
           "adhesion";
  if (!may && model.work_of_adhesion > 0)
    return "Contact/Work of adhesion is not felt: the normal law is one "
           "without adhesion";
  return {};
}

std::string adjusted_pressure_doubt(const dem::PackingRequest &packing)
{
  if (packing.contact.normal_law != dem::NormalLaw::thornton_ning_adjusted)
    return {};
  const auto &adjusted = packing.material.adjusted_pressures;
  if (adjusted.empty())
    return "Contact/Limiting contact pressures is empty: the normal law is "
           "thornton-ning";
  std::vector<std::string> places;
  for (const auto &[density, pressure] : adjusted)
    places.push_back(
        fmt::format("{:.4g} MPa at {:.4g}", pressure / 1e6, density));
  return fmt::format(
      "the limiting contact pressure p_y is adjusted to the relative density, "
      "{}: a fit of a measured curve, no property of the grains and no "
      "prediction for other paths",
      fmt::join(places, ", "));
}

void warn_of_contact_model(RunSession &session)
{
  const dem::PackingRequest &packing = session.input().material.packing;
  for (const std::string &doubt :
       {adhesion_doubt(packing.contact), adjusted_pressure_doubt(packing)})
    if (!doubt.empty())
      session.warn(doubt);
}

std::size_t different_packings(const coupling::MaterialChoice &choice,
                               std::size_t points)
{
  std::size_t different = points;
  if (choice.packings > 0)
    different = std::min(different, choice.packings);
  if (!choice.packing_files.empty())
    different = std::min(different, choice.packing_files.size());
  return different;
}

std::string packing_title(const coupling::MaterialChoice &choice,
                          std::size_t count)
{
  if (!choice.packing_files.empty())
    return fmt::format("reading {} packings", count);
  const dem::CompressionGoal &goal = choice.packing.goal;
  return fmt::format(
      "packing {} x {} grains to {}",
      count,
      choice.packing.grain_count,
      !choice.densities.empty() ? "their initial densities"
      : goal.target == dem::CompressionTarget::pressure
          ? fmt::format("{:.4g} MPa", goal.pressure / 1e6)
          : fmt::format("a relative density of {:.4g}", goal.relative_density));
}

void warn_of_history(RunSession &session, coupling::History history)
{
  if (history == coupling::History::slipped)
    session.warn("the stored packing was made with another friction "
                 "coefficient; contacts slipped where they had to");
  if (history == coupling::History::forgotten)
    session.warn("the stored packing has no contact history, or one of other "
                 "grains or contact laws: contacts begin with the overlaps "
                 "that they have, and the pressure may be another");
}

void warn_of_law(RunSession &session)
{
  const coupling::MaterialChoice &choice = session.input().material;
  if (choice.kind != coupling::MaterialKind::drucker_prager_cap)
    return;
  for (const fem::Remark &remark :
       fem::remarks(coupling::cap_parameters(choice.cap)))
    session.warn("Material/Drucker-Prager cap: " + remark.text());
}

coupling::Material
prepare_material(RunSession &session, const fem::Share &points, std::size_t all)
{
  coupling::MaterialChoice choice = session.input().material;
  choice.first_point = points.begin;
  if (session.resumes())
    choice.packings = 1;
  RunLog &log = session.log();
  const bool cells = choice.kind == coupling::MaterialKind::unit_cell;
  warn_of_law(session);
  if (cells) {
    warn_of_contact_model(session);
    log.begin(packing_title(choice, different_packings(choice, all)));
  }
  try {
    auto material =
        coupling::make_material(choice, points.size(), [&](std::size_t made) {
          // Other ranks make theirs at about the same pace.
          const double share =
              static_cast<double>(made) / static_cast<double>(points.size());
          log.step(share, share * static_cast<double>(all), "packings", "");
        });
    log.end();
    if (cells)
      session.result("time_packing[s]", log.progress().elapsed());
    return material;
  } catch (...) {
    rethrow_of_packing();
  }
}

void rethrow_of_packing()
{
  try {
    throw;
  } catch (const std::invalid_argument &) {
    throw;
  } catch (const coupling::FileError &error) {
    throw OutputError(error.what());
  } catch (const std::runtime_error &error) {
    throw PackingError(error.what());
  }
}

void warn_of_loose_cells(RunSession &session)
{
  const auto &material = session.input().material;
  if (material.kind == coupling::MaterialKind::unit_cell &&
      material.packing_files.empty() &&
      material.packing.goal.target == dem::CompressionTarget::pressure &&
      material.packing.goal.pressure < safe_start_pressure)
    session.warn(fmt::format(
        "Packing/Pressure = {:.3g} MPa: packings this loose may collapse in "
        "the first steps; 0.5 MPa or more is safe",
        material.packing.goal.pressure / 1e6));
}
} // namespace tamp::apps
