// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_material_factory_h
#define coupling_material_factory_h

#include <coupling/packing_adoption.h>
#include <dem/deform.h>
#include <dem/packing.h>
#include <fem/laws/cap_surface.h>
#include <fem/laws/fkm_gurson.h>
#include <fem/laws/modified_cam_clay.h>
#include <fem/material_points.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace tamp::fem
{
struct DruckerPragerCapParameters;
}

namespace tamp::coupling
{
class UnitCellPoints;

enum class MaterialKind {
  unit_cell,
  elastic,
  drucker_prager_cap,
  modified_cam_clay,
  fkm_gurson
};

/// Elasticity of a compact over its relative density; between the nodes
/// linear, outside as at the nearest node. One node: constant.
struct ElasticTable {
  std::vector<double> relative_density; ///< increasing [-]
  std::vector<double> youngs_modulus;   ///< [Pa]
  std::vector<double> poissons_ratio;   ///< [-]
};

struct ElasticChoice {
  double initial_relative_density = 0.6; ///< [-]
  ElasticTable elasticity;
};

/// A Drucker-Prager cap over relative density.
struct CapChoice {
  double initial_relative_density = 0.34; ///< [-]
  ElasticTable elasticity;
  std::vector<double> relative_density;  ///< of the three tables below [-]
  std::vector<double> cohesion;          ///< d [Pa]
  std::vector<double> friction_angle;    ///< beta in the p-q plane [rad]
  std::vector<double> cap_eccentricity;  ///< R [-]
  std::vector<double> hardening_density; ///< increasing [-]
  std::vector<double> hydrostatic_yield; ///< p_b [Pa]
  double transition = 0;                 ///< alpha [-]
  fem::Dilation dilation = fem::Dilation::bounded;
  double integration_tolerance = 1.5e-4; ///< see the law [-]
};

/// The constants of the law. Throws std::invalid_argument if a table is none.
fem::DruckerPragerCapParameters cap_parameters(const CapChoice &choice);

/// Which material the points are made of, and all that it needs. The fields of
/// the other materials are not used.
struct MaterialChoice {
  MaterialKind kind = MaterialKind::unit_cell;
  dem::PackingRequest packing; ///< its seed is that of the run
  /// Stored packings; empty: `packing` is made.
  std::vector<std::filesystem::path> packing_files;
  /// Different packings, which points take in turn; 0: all stored ones, or
  /// one for each point.
  std::size_t packings = 0;
  std::size_t first_packing = 0; ///< of the run's packings, that of point 0
  std::size_t first_point = 0;   ///< number in the run of the first to be made
  /// Relative density at the start of each point of the run; empty: that of the
  /// law, or as packed. A cell is then packed to that density, at the pressure
  /// that this takes.
  std::vector<double> densities;
  dem::Driving driving;
  bool warm = true; ///< see CellPointsOptions
  unsigned threads = 1;
  ElasticChoice elastic;
  CapChoice cap;
  fem::ModifiedCamClayParameters cam_clay;
  fem::FkmGursonParameters fkm_gurson;
};

/// The points of a die or of a probe. `cells` is the same object as `points`
/// if these are unit cells, otherwise null.
struct Material {
  std::unique_ptr<fem::MaterialPoints> points;
  UnitCellPoints *cells = nullptr;
  History history = History::kept; ///< of stored packings
};

/// Makes `count` points; the only place where all materials are known.
/// `progress` is told how many packings are ready (from one thread at a time).
/// Throws std::invalid_argument if a value is not physical and
/// std::runtime_error if a packing does not jam; what else read_packing()
/// throws.
Material make_material(const MaterialChoice &choice,
                       std::size_t count,
                       const std::function<void(std::size_t)> &progress = {});

/// A material of one point in the committed state of point 0 of another one,
/// which was made by the same choice. Its cell is driven by one thread.
Material copy_point(const MaterialChoice &choice, const Material &material);
} // namespace tamp::coupling

#endif
