// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_die_maps_h
#define apps_die_maps_h

#include <apps/plots.h>
#include <fem/die_model.h>

#include <filesystem>
#include <functional>
#include <vector>

namespace tamp::apps
{
/// The quarter of its element that each material point of an axisymmetric
/// compact stands for, in the committed state, with a value of its answer: the
/// four points of an element fix its bilinear shape.
std::vector<ValueQuadrilateral>
point_map(const fem::DieModel &model,
          const std::function<double(const fem::Response &)> &value);

/// The same with the mean of each element's points: for stresses, which are
/// most accurate at the centre of a bilinear element (J. Barlow, 1976) and
/// alternate about it in large gradients.
std::vector<ValueQuadrilateral>
element_map(const fem::DieModel &model,
            const std::function<double(const fem::Response &)> &value);

/// Pictures of an axisymmetric compact at the peak and at the end. At the end
/// these are the density and, compression positive, the axial and the hoop
/// stress: tension along the axis parts a compact in layers (capping,
/// lamination), hoop tension opens cracks along the axis. The other two
/// components vanish at the free faces where cracks begin.
class DieMaps
{
public:
  /// Take the state that the model has now.
  void take_peak(const fem::DieModel &model);
  void take_end(const fem::DieModel &model);
  /// Writes the tables that the plots of die_plots() draw. Throws OutputError.
  void write(const std::filesystem::path &folder) const;

private:
  std::vector<ValueQuadrilateral> peak_density_, density_, axial_stress_,
      hoop_stress_;
};
} // namespace tamp::apps

#endif
