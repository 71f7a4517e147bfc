// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_law_text_h
#define apps_fit_law_text_h

#include <coupling/material_factory.h>

#include <string>
#include <utility>
#include <vector>

namespace tamp::apps
{
/// A section Material that any input of tamp can include. Numbers have seven
/// digits. @param remarks  lines that stand above it as comments.
std::string cap_text(const coupling::CapChoice &law,
                     const std::vector<std::string> &remarks);

/// The same for a law of constants: `entries` are names and values with units.
std::string
constants_text(const std::string &type,
               const std::string &subsection,
               const std::vector<std::pair<std::string, std::string>> &entries,
               const std::vector<std::string> &remarks);

/// The cap as a *MATERIAL of Abaqus in SI: *ELASTIC and *CAP PLASTICITY with
/// the relative density of the unloaded powder as field variable 1, and *CAP
/// HARDENING over the volumetric inelastic strain since the first density of
/// the hardening table. Source: Abaqus Keywords Reference Guide.
std::string abaqus_text(const coupling::CapChoice &law,
                        const std::vector<std::string> &remarks);

/// Modified Cam-Clay as a *MATERIAL of Abaqus/Standard in SI: *POROUS ELASTIC
/// and *CLAY PLASTICITY with exponential hardening, to begin on the line of
/// first compression, under the pressure p_c; comments have the initial
/// conditions. That line and the surfaces are those of the law. Swelling is
/// not: in Abaqus kappa counts the volume of the powder before plastic
/// compaction, ln(p / p_0) kappa / (1 + e_0) = 1 - J_el, and so it is too stiff
/// by the plastic change of volume; a comment says how much.
/// @param last_density  up to which the law was fitted, for that comment [-]
/// Source: Abaqus Materials Guide, Critical state (clay) plasticity model.
std::string abaqus_text(const fem::ModifiedCamClayParameters &law,
                        double last_density,
                        const std::vector<std::string> &remarks);
} // namespace tamp::apps

#endif
