// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_die_model_h
#define fem_die_model_h

#include <fem/die_settings.h>
#include <fem/material_points.h>
#include <fem/mesh.h>
#include <fem/ranks.h>
#include <fem/work_account.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tamp::fem
{
/// What an accepted step ended with. Forces are compression positive.
struct StepRecord {
  unsigned step = 0;
  unsigned stage = 0;             ///< index in the schedule, from 0
  double upper_displacement = 0;  ///< of the upper punch, downwards [m]
  double lower_displacement = 0;  ///< of the lower punch, upwards [m]
  double die_displacement = 0;    ///< of the die, upwards [m]
  double upper_force = 0;         ///< powder on upper punch, upwards [N]
  double lower_force = 0;         ///< lower punch on powder, upwards [N]
  double wall_friction_force = 0; ///< wall on powder, upwards [N]
  double wall_normal_force = 0;   ///< [N]
  double wall_area = 0;           ///< in contact [m2]
  double punch_area = 0;          ///< [m2]
  double compact_height = 0;      ///< between the punch faces, mean [m]
  double compact_radius = 0;      ///< largest distance from the axis [m]
  double mean_relative_density = 0;
  double minimum_relative_density = 0;
  double maximum_relative_density = 0;
  unsigned iterations = 0;        ///< of the accepted attempt
  unsigned material_updates = 0;  ///< evaluations of all points, cut attempts
                                  ///< included
  unsigned cuts = 0;              ///< attempts given up before this one
  double force_residual = 0;      ///< / reactions [-]
  double displacement_change = 0; ///< / increment, in the last iteration [-]
  bool stagnated = false;         ///< out of balance, see Attempt
  std::size_t doubtful_points = 0;
  double stage_progress = 0; ///< 0 to 1
  WorkAccount work;          ///< since the start
};

enum class FailureKind {
  not_converged, ///< a step found no equilibrium
  opened,        ///< but one in which a material point opens, see Opening
  impossible     ///< the schedule asks for what cannot be done
};

/// Why and where a run could not go on. Position and stress are those of the
/// last accepted state.
struct Failure {
  FailureKind kind = FailureKind::not_converged;
  std::string reason;
  std::size_t point = 0;
  dealii::Tensor<1, 3> position;        ///< y = 0 if axisymmetric [m]
  dealii::SymmetricTensor<2, 3> stress; ///< tension positive [Pa]
};

enum class Advance { stepped, finished, failed };

/// A named value per material point, for output.
struct PointField {
  std::string name;
  std::vector<double> values;
  std::string meaning; ///< with its unit, for the comment of the file
};

/// The variables of all points in their committed state.
std::vector<PointField> variable_fields(const MaterialPoints &points);

/// Seconds spent since the start, by part.
struct ModelTimes {
  double material = 0, assembly = 0, contact = 0, linear_solver = 0, total = 0;
};

/// A compact in a die, pressed, unloaded and ejected step by step: updated
/// Lagrangian, rigid tools with friction. Knows nothing of what its material
/// points are.
class DieModel
{
public:
  /// Called when a stage begins, before its first step, with the stage's index
  /// and the largest pressure of the upper punch so far [Pa]. The direction of
  /// loading turns here.
  using StageBegins = std::function<void(unsigned stage, double peak_pressure)>;

  /// The material points must be at the state of the start: their stress may be
  /// anything; the first step finds equilibrium. Throws std::invalid_argument
  /// if sizes do not match. Mesh and points must outlive the model.
  /// @param points  of this rank's share of the mesh, see Ranks::share().
  /// @param state  what pack() of another model wrote, with the same settings
  /// and mesh: the model goes on from there, step by step to the bit. The
  /// points are to be unpacked to their states of then before advance(). Empty:
  /// the start. The same on all ranks, of which there may be another number.
  /// Throws std::runtime_error if it is that of another model.
  DieModel(const DieSettings &settings,
           const Mesh &mesh,
           MaterialPoints &points,
           StageBegins stage_begins = {},
           const Ranks &ranks = Ranks(),
           std::span<const char> state = {});
  ~DieModel();

  /// Does one step of the schedule, cutting it as often as needed, and says
  /// `stepped`; says `finished`, and does nothing, once no stage is left. A
  /// step that fails leaves the last accepted state, in the model and in the
  /// points.
  [[nodiscard]] Advance advance();

  /// Appends the accepted state, but for that of the points, to `bytes` of the
  /// first rank. Collective.
  void pack(std::vector<char> &bytes) const;

  /// The last accepted step; before the first one, step 0: the start.
  const StepRecord &last_step() const;
  const Failure &failure() const;
  ModelTimes times() const;

  /// Responses of the committed state, one per point of this rank.
  const std::vector<Response> &responses() const;
  /// Places of the points in the committed state; y = 0 if axisymmetric [m].
  std::vector<dealii::Tensor<1, 3>> point_positions() const;
  /// F since the start of every point: the product of relative_F.
  const std::vector<dealii::Tensor<2, 3>> &deformation_gradients() const;
  /// One value for each point of this rank at its place among those of all
  /// points, on every rank. Collective.
  std::vector<double> whole(const std::vector<double> &of_this_rank) const;

  /// Writes the committed state as `folder`/`name`.vtu: each element as four
  /// quadrilaterals, one per material point, with displacement, Cauchy stress,
  /// relative density, numbers of point and cell and the extra fields. Throws
  /// std::runtime_error naming the file if it cannot be written. Collective;
  /// the first rank writes.
  void write_fields(const std::filesystem::path &folder,
                    const std::string &name,
                    const std::vector<PointField> &extra = {}) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};
} // namespace tamp::fem

#endif
