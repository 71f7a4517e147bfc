// SPDX-License-Identifier: BSD-3-Clause
#include <apps/run_material.h>

#include <fmt/format.h>
#include <stdexcept>

namespace tamp::apps
{
namespace
{
constexpr double densest_of_pairs = 0.82;
} // namespace

void warn_of_contact_model(RunSession &session)
{
  const dem::ContactModel &model = session.input().material.packing.contact;
  const bool adhesive = model.normal_law == dem::NormalLaw::jkr ||
                        model.normal_law == dem::NormalLaw::thornton_ning_jkr;
  if (adhesive && !(model.work_of_adhesion > 0))
    session.warn("Contact/Work of adhesion is 0: the normal law is that "
                 "without adhesion");
  if (!adhesive && model.work_of_adhesion > 0)
    session.warn("Contact/Work of adhesion is not felt: the normal law is one "
                 "without adhesion");
}

coupling::Material prepare_material(RunSession &session, std::size_t count)
{
  const coupling::MaterialChoice &choice = session.input().material;
  RunLog &log = session.log();
  const bool cells = choice.kind == coupling::MaterialKind::unit_cell;
  if (cells) {
    warn_of_contact_model(session);
    log.begin(fmt::format("packing {} x {} grains to {:.4g} MPa",
                          choice.same_packing ? 1 : count,
                          choice.packing.grain_count,
                          choice.packing.pressure / 1e6));
  }
  try {
    auto material =
        coupling::make_material(choice, count, [&](std::size_t made) {
          log.step(static_cast<double>(made) / static_cast<double>(count),
                   static_cast<double>(made),
                   "packings",
                   "");
        });
    log.end();
    if (cells)
      session.result("time_packing[s]", log.progress().elapsed());
    return material;
  } catch (const std::invalid_argument &) {
    throw;
  } catch (const std::runtime_error &error) {
    throw PackingError(error.what());
  }
}

void warn_beyond_pair_laws(RunSession &session, double mean_relative_density)
{
  if (mean_relative_density > densest_of_pairs)
    session.warn(fmt::format("contact laws of pairs lose accuracy above a "
                             "relative density of about {}",
                             densest_of_pairs));
}
} // namespace tamp::apps
