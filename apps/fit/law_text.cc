// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/law_text.h>

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tamp::apps
{
namespace
{
constexpr double degree = std::numbers::pi / 180;
constexpr std::size_t line_width = 78;

// The words of `text` in lines that begin with `mark`.
std::string comment(const std::string &mark, const std::string &text)
{
  std::string lines, line = mark;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (line.size() + 1 + word.size() > line_width && line != mark) {
      lines += line + "\n";
      line = mark;
    }
    line += " " + word;
    begin = end + 1;
  }
  return lines + line + "\n";
}

std::string comments(const std::string &mark,
                     const std::vector<std::string> &remarks)
{
  std::string text;
  for (const std::string &remark : remarks)
    text += comment(mark, remark);
  return text;
}

// A list over as many lines as it needs.
std::string entry(const std::string &name,
                  const std::vector<double> &values,
                  double unit = 1,
                  const std::string &unit_name = "")
{
  const std::string indent(8, ' ');
  std::string text, line = "    set " + name + " =";
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool last = i + 1 == values.size();
    const std::string word =
        fmt::format(" {:.7g}{}", values[i] / unit, last ? unit_name : ",");
    if (line.size() + word.size() > line_width - 2) {
      text += line + " \\\n";
      line = indent;
    }
    line += word;
  }
  return text + line + "\n";
}

void append_cap_data(const coupling::CapChoice &law, std::string &text)
{
  text += "*ELASTIC, DEPENDENCIES=1\n** E, nu, temperature, relative density\n";
  const coupling::ElasticTable &elastic = law.elasticity;
  for (std::size_t i = 0; i < elastic.relative_density.size(); ++i)
    text += fmt::format("{:.7g}, {:.7g}, , {:.7g}\n",
                        elastic.youngs_modulus[i],
                        elastic.poissons_ratio[i],
                        elastic.relative_density[i]);
  const double reference = law.hardening_density.front();
  const double start = std::log(law.initial_relative_density / reference);
  text += "*CAP PLASTICITY, DEPENDENCIES=1\n** d, beta [degrees], R, initial "
          "strain, alpha, K, temperature,\n** relative density\n";
  for (std::size_t i = 0; i < law.relative_density.size(); ++i)
    text +=
        fmt::format("{:.7g}, {:.7g}, {:.7g}, {:.9f}, {:.7g}, 1., , {:.7g}\n",
                    law.cohesion[i],
                    law.friction_angle[i] / degree,
                    law.cap_eccentricity[i],
                    start,
                    law.transition,
                    law.relative_density[i]);
  text += "*CAP HARDENING\n** p_b, volumetric inelastic strain\n";
  for (std::size_t i = 0; i < law.hardening_density.size(); ++i)
    text += fmt::format("{:.7g}, {:.9f}\n",
                        law.hydrostatic_yield[i],
                        std::log(law.hardening_density[i] / reference));
}
} // namespace

std::string cap_text(const coupling::CapChoice &law,
                     const std::vector<std::string> &remarks)
{
  constexpr double MPa = 1e6;
  return comments("#", remarks) +
         "subsection Material\n  set Type = drucker-prager cap\n"
         "  subsection Drucker-Prager cap\n" +
         entry("Initial relative density", {law.initial_relative_density}) +
         entry("Elastic densities", law.elasticity.relative_density) +
         entry("Young's modulus", law.elasticity.youngs_modulus, MPa, " MPa") +
         entry("Poisson's ratio", law.elasticity.poissons_ratio) +
         entry("Shape densities", law.relative_density) +
         entry("Cohesion", law.cohesion, MPa, " MPa") +
         entry("Friction angle", law.friction_angle, degree, " deg") +
         entry("Cap eccentricity", law.cap_eccentricity) +
         entry("Hardening densities", law.hardening_density) +
         entry(
             "Hydrostatic yield pressure", law.hydrostatic_yield, MPa, " MPa") +
         entry("Transition", {law.transition}) + "  end\nend\n";
}

std::string
constants_text(const std::string &type,
               const std::string &subsection,
               const std::vector<std::pair<std::string, std::string>> &entries,
               const std::vector<std::string> &remarks)
{
  std::string text = comments("#", remarks) +
                     fmt::format("subsection Material\n  set Type = {}\n"
                                 "  subsection {}\n",
                                 type,
                                 subsection);
  for (const auto &[name, value] : entries)
    text += fmt::format("    set {} = {}\n", name, value);
  return text + "  end\nend\n";
}

std::string abaqus_text(const coupling::CapChoice &law,
                        const std::vector<std::string> &remarks)
{
  std::string text =
      comments("**", remarks) +
      comment("**",
              "Units: Pa. Field variable 1 is the relative density of the "
              "unloaded powder, D = D_ref exp(volumetric inelastic strain, "
              "compaction positive), which the user subroutine USDFLD (VUSDFLD "
              "in Abaqus/Explicit) keeps in state variable 1 and gives to the "
              "material. It begins at the initial relative density.") +
      fmt::format("** D_ref = {:.7g}\n** initial relative density = {:.7g}\n",
                  law.hardening_density.front(),
                  law.initial_relative_density) +
      comment("**",
              "Dilation in shear failure is that of Abaqus; tamp bounds it "
              "unless Dilation = full.") +
      "*MATERIAL, NAME=POWDER\n*DEPVAR\n1,\n*USER DEFINED FIELD\n";
  append_cap_data(law, text);
  return text;
}

std::string abaqus_text(const fem::ModifiedCamClayParameters &law,
                        double last_density,
                        const std::vector<std::string> &remarks)
{
  const double p_c = law.initial_yield_pressure, kappa = law.swelling_index,
               lambda = law.compression_index, floor = law.floor_pressure;
  // Loaded elastically from no stress to p_c.
  const double swelling = p_c > floor ? 1 + std::log(p_c / floor) : p_c / floor;
  const double volume = 1 / law.initial_relative_density - kappa * swelling;
  // ln(p_c / p_c0) on the line of first compression.
  const double growth = (volume - 1 / last_density) / lambda;
  const double stiffer = (volume - kappa * growth) * last_density;
  return comments("**", remarks) +
         comment("**",
                 "Units: Pa. The powder begins on its line of first "
                 "compression, under the pressure p_c, as *POROUS ELASTIC "
                 "needs a pressure; tamp begins without stress.") +
         fmt::format("** *INITIAL CONDITIONS, TYPE=STRESS\n"
                     "**   powder, {0:.7g}, {0:.7g}, {0:.7g}, 0., 0., 0.\n"
                     "** *INITIAL CONDITIONS, TYPE=RATIO\n"
                     "**   powder, {1:.9g}\n",
                     -p_c,
                     volume - 1) +
         comment(
             "**",
             fmt::format(
                 "First compression and yield surfaces are those of tamp. "
                 "Elasticity is not: for tamp the bulk modulus is v p / kappa "
                 "with the volume v = 1 / D of the powder as it is, for Abaqus "
                 "with that before its plastic compaction. Abaqus is stiffer "
                 "by the ratio, from 1 at the start to {:.3g} at a relative "
                 "density of {:.4g}, and so is spring-back less.",
                 stiffer,
                 last_density)) +
         "*MATERIAL, NAME=POWDER\n"
         "*POROUS ELASTIC, SHEAR=POISSON\n** kappa, nu, tensile limit\n" +
         fmt::format("{:.7g}, {:.7g}, 0.\n", kappa, law.poissons_ratio) +
         "*CLAY PLASTICITY, HARDENING=EXPONENTIAL\n"
         "** lambda, M, a_0 = p_c / 2, beta, K\n" +
         fmt::format("{:.7g}, {:.7g}, {:.7g}, 1., 1.\n",
                     lambda,
                     law.critical_state_slope,
                     p_c / 2);
}
} // namespace tamp::apps
