// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_calibrate_curve_simulator_h
#define apps_calibrate_curve_simulator_h

#include <apps/calibrate/compaction_curve.h>
#include <apps/input/run_input.h>

#include <mutex>
#include <string>

namespace tamp::apps
{
/// What a run gave. If it did not come to its end, the reason.
struct SimulatedCurve {
  CompactionCurve curve;
  std::string problem; ///< empty: none
};

/// Thrown between two steps of a run after a signal, see caught_signal().
struct SimulationInterrupted {
};

/// Compacts a powder without a folder: in a die, or one material point along
/// the path of the input, whose first stage loads and whose others unload. A
/// probe or a die of the same input takes the same steps, to the bit.
class CurveSimulator
{
public:
  enum class Model { probe, die };

  explicit CurveSimulator(Model model) : model_(model) {}

  /// Several points may be compacted at the same time from different threads,
  /// dies only one after the other. Throws OutputError if a stored packing
  /// cannot be read; all else that goes wrong is told.
  SimulatedCurve run(const RunInput &input) const;

  /// The relative density at which runs of this input start [-]. Throws
  /// std::runtime_error if it has no such state.
  double start_density(const RunInput &input) const;

  Model model() const { return model_; }

private:
  coupling::Material make_material(const coupling::MaterialChoice &choice,
                                   std::size_t count) const;
  SimulatedCurve probe(const RunInput &input) const;
  SimulatedCurve press(const RunInput &input) const;

  Model model_;
  mutable std::mutex
      reading_; ///< the library of packing files wants one reader
};
} // namespace tamp::apps

#endif
