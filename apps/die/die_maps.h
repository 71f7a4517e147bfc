// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_die_die_maps_h
#define apps_die_die_maps_h

#include <apps/output/plots.h>
#include <fem/die_model.h>
#include <fem/state_bytes.h>

#include <filesystem>
#include <vector>

namespace tamp::apps
{
/// Pictures of the section of a compact, see section_map(), at the peak and at
/// the end. At the end these are the density and, compression positive, the
/// axial and the hoop stress: tension along the axis parts a compact in layers
/// (capping, lamination), hoop tension opens cracks along the axis. The other
/// two components vanish at the free faces where cracks begin.
class DieMaps
{
public:
  /// Take the state that the model has now.
  /// @name Takes the state that the model has now. Collective.
  /// @{
  void take_peak(const fem::Mesh &mesh, const fem::DieModel &model);
  void take_end(const fem::Mesh &mesh, const fem::DieModel &model);
  /// @}

  /// Appends the map of the peak; go_on() takes it up.
  void pack(std::vector<char> &bytes) const;
  void go_on(fem::StateBytes &stored);

  bool empty() const { return density_.empty(); }
  /// Writes the tables that the plots of die_plots() draw. Throws OutputError.
  void write(const std::filesystem::path &folder) const;

private:
  std::vector<ValueQuadrilateral> peak_density_, density_, axial_stress_,
      hoop_stress_;
};
} // namespace tamp::apps

#endif
