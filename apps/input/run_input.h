// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_run_input_h
#define apps_input_run_input_h

#include <apps/input/contact_parameters.h>
#include <apps/input/probe_path.h>
#include <apps/input/scan_settings.h>
#include <coupling/material_factory.h>
#include <fem/die_settings.h>
#include <fem/mesh_import.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tamp::apps
{
class ParameterTable;

enum class GrainOutput { none, chosen_points, all };

/// What is written, and how often.
struct OutputSettings {
  unsigned field_interval = 5; ///< steps between fields on disk
  unsigned grain_interval = 5; ///< steps between grains on disk
  GrainOutput grain_output = GrainOutput::chosen_points;
  std::vector<std::size_t> grain_points;
  std::vector<std::string> plot_formats; ///< "svg", "png", "pdf"
  double checkpoint_interval = 600;      ///< [s]; zero: at signals only
  unsigned bias_interval = 10;           ///< steps; zero: never
};

/// All that an input file says, in SI.
struct RunInput {
  coupling::MaterialChoice material;
  ProbePath path;
  double stress_tolerance = 1e-3; ///< of the probe's stress control [-]
  ScanSettings scan;              ///< of the probe
  fem::DieSettings die;
  fem::ImportedMesh mesh; ///< of the powder in the die
  PairInput pair;
  OutputSettings output;
  std::size_t replicas = 1; ///< packings that tamp pack makes
  /// Files that the run reads besides the input.
  std::vector<std::filesystem::path> files;
};

/// Declares every parameter of the program.
void declare_parameters(ParameterTable &table);

/// Which part of the input a command needs: the other parts may be left as they
/// are, even if they do not fit the material. A point needs its material only.
enum class Need { everything, probe, die, pack, contact, point };

/// Turns values into settings. Throws InputError where values do not fit
/// together, or where a file that they name is missing.
RunInput read_input(const ParameterTable &table, Need need);
} // namespace tamp::apps

#endif
