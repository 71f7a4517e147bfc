// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_probe_probe_scan_h
#define apps_probe_probe_scan_h

#include <apps/input/scan_settings.h>
#include <apps/output/curve_writer.h>
#include <apps/run/run_session.h>
#include <coupling/material_factory.h>
#include <fem/path_driver.h>
#include <fem/small_probes.h>
#include <fem/yield_branch.h>

#include <memory>
#include <optional>
#include <vector>

namespace tamp::apps
{
/// Yield points and moduli of a probe's powder: at each density of `Scan` that
/// its path comes to, branches start from a copy of the point. The path itself
/// is as if nobody had looked, to the bit. Writes yield.csv and moduli.csv.
class ProbeScan
{
public:
  /// @param session, material  must outlive the object; in a run that resumes,
  ///                           go_on() must follow
  /// @param replica  what the files call the powder
  ProbeScan(RunSession &session,
            const coupling::Material &material,
            unsigned replica = 1);

  /// Takes the state after an increment of the path, the start first; the
  /// material is in that state. Throws InputError if the start is denser than
  /// a density to come.
  void take(const fem::PathRecord &record);

  /// Appends what it has written and remembers; go_on() takes it up, once the
  /// material is in that state again.
  void pack(std::vector<char> &bytes) const;
  void go_on(fem::StateBytes &stored);

  /// Whether there are yield points.
  bool found() const { return points_ > 0; }
  /// What is left to say at the end: densities that were not reached.
  void give() const;

private:
  struct Reached;
  struct Branch;

  void write_moduli(double density, const fem::MeasuredModuli &moduli);
  void scan(double density, const fem::PathRecord &record);
  Reached reach(double density, const fem::PathRecord &record) const;
  std::vector<Branch> branches_of(Reached &reached);
  void drive(const Reached &reached, std::vector<Branch> &branches);
  fem::BranchDriving driving(const coupling::Material &point) const;
  coupling::Material copy_at(std::span<const char> state) const;

  RunSession &session_;
  const ScanSettings &settings_;
  const coupling::Material &material_;
  unsigned replica_;
  std::optional<CurveWriter> yield_, moduli_;
  std::size_t next_ = 0;     ///< density to come
  std::vector<char> before_; ///< the point's state at the step before
  double density_before_ = 0;
  dealii::Tensor<2, 3> F_before_;
  double points_ = 0, lost_ = 0; ///< yield points, branches that failed
};
} // namespace tamp::apps

#endif
