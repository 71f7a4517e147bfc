// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/cap_increment.h>
#include <fem/laws/cap_return.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace tamp::fem
{
using dealii::SymmetricTensor;

namespace
{
using Surface = DruckerPragerCap::Surface;

/// A part is never shorter than 2^-8 of what it began with.
constexpr unsigned most_halvings = 8;

using Six = std::array<double, 6>; ///< a tensor, order of SymmetricTensor

/// All that an isotropic law can take from a strain: the derivatives are by
/// v = -tr(strain), w = s_0 : e and u = e : e, where s_0 is the deviator of the
/// old stress and e that of the strain.
using ByInvariants = Sacado::Fad::SFad<double, 3>;

double contract(const Six &a, const Six &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] +
         2 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

Six entries(const SymmetricTensor<2, 3> &tensor)
{
  Six result;
  for (unsigned k = 0; k < 6; ++k)
    result[k] = tensor.access_raw_entry(k);
  return result;
}

/// What changes during an increment. The deviator of stress stays in the plane
/// of s_0 and e: s = old_share s_0 + strain_share e.
template <class Number>
struct Point {
  Number old_share;    ///< [-]
  Number strain_share; ///< [Pa]
  Number p;            ///< compression positive [Pa]
  Number compaction;   ///< eps [-]
  double plastic_shear = 0;
  Surface surface = Surface::none;
  CapSurface<ByCompaction> at; ///< the surface at eps
};

/// The unknown change of compaction with its derivatives, from the implicit
/// function theorem.
template <class Number>
Number lift(const CapTrial<Number> &trial, const CapReturn &found)
{
  Number x = found.compaction_change;
  if constexpr (!std::is_same_v<Number, double>) {
    const auto residual = return_residual<Number>(
        carry(found.at, trial.compaction),
        trial,
        found.surface == Surface::cap,
        {Number(found.compaction_change), Number(found.position)});
    const auto &inverse = found.inverse_jacobian[0];
    for (unsigned k = 0; k < 3; ++k)
      x.fastAccessDx(k) =
          -inverse[0] * residual[0].dx(k) - inverse[1] * residual[1].dx(k);
  }
  return x;
}

/// q / q_trial from the flow rule, in the form that is regular at q_trial = 0
/// where that is possible.
template <class Number>
Number deviator_ratio(const bool on_cap,
                      const CapSurface<Number> &s,
                      const CapTrial<Number> &trial,
                      const Number &p,
                      const Number &x)
{
  using std::sqrt;
  const Number stiffness = 3. * trial.shear * x / (s.factor * s.factor);
  if (on_cap) {
    const Number off = p - s.centre;
    if (value_of(off) > 0.7 * value_of(s.radius()))
      return Number(1. /
                    (1. + stiffness * s.eccentricity * s.eccentricity / off));
    const Number place = off / s.radius();
    return Number(s.top() * sqrt(1. - place * place) / trial.q);
  }
  const Number off = s.centre - p;
  if (value_of(off) > 0.5 * value_of(Number(s.centre - s.apex())))
    return Number(1. / (1. - stiffness / (off * s.tan_beta * s.tan_beta)));
  return Number(s.shear_limit(p) / trial.q);
}

template <class Number>
class Increment
{
public:
  Increment(const DruckerPragerCapParameters &parameters,
            const DruckerPragerCap::State &old,
            const SymmetricTensor<2, 3> &strain)
      : parameters_(parameters), tables_(parameters),
        old_(entries(deviator(old.stress))), strain_(entries(deviator(strain))),
        volume_(-trace(strain)), mixed_(contract(old_, strain_)),
        square_(contract(strain_, strain_)), size_(strain.norm())
  {
    if constexpr (!std::is_same_v<Number, double>) {
      volume_.diff(0, 3);
      mixed_.diff(1, 3);
      square_.diff(2, 3);
    }
    point_.old_share = 1.;
    point_.strain_share = 0.;
    point_.p = pressure(old.stress);
    point_.compaction = old.plastic_compaction;
    point_.plastic_shear = old.plastic_shear;
    point_.at = tables_.surface(old.plastic_compaction);
  }

  /// False if the increment failed.
  bool integrate()
  {
    const double parts = std::max(
        1., std::ceil(size_ / parameters_.maximum_strain_increment - 1e-9));
    for (unsigned i = 0; i < parts; ++i)
      if (!advance(1 / parts, most_halvings))
        return false;
    return std::isfinite(value_of(point_.p)) &&
           std::isfinite(value_of(point_.old_share)) &&
           std::isfinite(value_of(point_.strain_share));
  }

  CapAnswer answer() const
  {
    CapAnswer result;
    for (unsigned k = 0; k < 6; ++k)
      result.stress.stress.access_raw_entry(k) =
          value_of(point_.old_share) * old_[k] +
          value_of(point_.strain_share) * strain_[k] -
          (k < 3 ? value_of(point_.p) : 0);
    if constexpr (!std::is_same_v<Number, double>)
      result.stress.by_log_stretch = tangent();
    result.plastic_compaction = value_of(point_.compaction);
    result.plastic_shear = point_.plastic_shear;
    result.surface = point_.surface;
    result.is_resolved = is_resolved_;
    return result;
  }

private:
  /// A share of the increment in one part and in two, which makes an answer of
  /// second order and an estimate of error; where that is too large, or a part
  /// does not converge, the same for its halves.
  /// @param whole  the share in one part, if it is known.
  bool advance(const double share,
               const unsigned halvings,
               const Point<Number> *known = nullptr)
  {
    Point<Number> whole = known ? *known : point_;
    bool good = known || part(whole, share);
    if (good && whole.surface == Surface::none) {
      point_ = whole;
      return true;
    }
    Point<Number> half = point_;
    const bool half_good = part(half, share / 2);
    if (half_good && half.surface == Surface::none && halvings > 0) {
      // One part and two would agree, however far they flow.
      point_ = half;
      return advance(share / 2, halvings - 1);
    }
    Point<Number> both = half;
    good = good && half_good && part(both, share / 2);
    if (good) {
      const bool exact =
          difference(whole, both) <= parameters_.integration_tolerance;
      if (exact || halvings == 0) {
        point_ = joined(whole, both);
        is_resolved_ = is_resolved_ && exact;
        return true;
      }
    }
    return halvings > 0 &&
           advance(share / 2, halvings - 1, half_good ? &half : nullptr) &&
           advance(share / 2, halvings - 1);
  }

  Six deviator_of(const double old_share, const double strain_share) const
  {
    Six s;
    for (unsigned k = 0; k < 6; ++k)
      s[k] = old_share * old_[k] + strain_share * strain_[k];
    return s;
  }
  Six deviator_of(const Point<Number> &point) const
  {
    return deviator_of(value_of(point.old_share), value_of(point.strain_share));
  }

  /// Of two stresses, over their norm; a hundredth of the size of the surface
  /// is added so that stresses close to zero need no better.
  double difference(const Point<Number> &a, const Point<Number> &b) const
  {
    Six s = deviator_of(a);
    const Six t = deviator_of(b);
    const double p = value_of(b.p),
                 size = value_of(b.at.radius()) + value_of(b.at.strength);
    const double norm = std::sqrt(contract(t, t) + 3 * p * p) + 0.01 * size;
    for (unsigned k = 0; k < 6; ++k)
      s[k] -= t[k];
    const double off = value_of(a.p) - p;
    return std::sqrt(contract(s, s) + 3 * off * off) / norm;
  }

  /// From the same share in one part and in two, each with an error of second
  /// order in it: what has one of third order, drawn to the surface. Where the
  /// branches differ the two parts stand.
  Point<Number> joined(const Point<Number> &one, const Point<Number> &two)
  {
    if (two.surface == Surface::none ||
        (one.surface == Surface::cap) != (two.surface == Surface::cap))
      return two;
    Point<Number> point = two;
    point.old_share = 2. * two.old_share - one.old_share;
    point.strain_share = 2. * two.strain_share - one.strain_share;
    point.p = 2. * two.p - one.p;
    point.compaction = 2. * two.compaction - one.compaction;
    point.plastic_shear = 2 * two.plastic_shear - one.plastic_shear;
    point.at = tables_.surface(value_of(point.compaction));
    const auto s = carry(point.at, point.compaction);
    const bool on_cap = two.surface == Surface::cap;
    if (on_cap != (value_of(point.p) > value_of(s.centre)))
      return two;
    const Number q = deviatoric(point.old_share, point.strain_share, point.at);
    const Number ratio = s.draw(point.p, q);
    point.old_share *= ratio;
    point.strain_share *= ratio;
    return point;
  }

  /// One backward Euler part. False, and nothing changed, if the return did
  /// not meet its tolerance.
  bool part(Point<Number> &point, const double share)
  {
    CapTrial<Number> trial;
    const auto moduli = tables_.moduli(value_of(point.compaction));
    trial.bulk = carry(moduli.bulk, point.compaction);
    trial.shear = carry(moduli.shear, point.compaction);
    trial.compaction = point.compaction;
    trial.p = point.p + trial.bulk * share * volume_;
    const Number strain_share = point.strain_share + 2. * share * trial.shear;
    trial.q = deviatoric(point.old_share, strain_share, point.at);

    const CapReturn found = return_to_surface(tables_,
                                              point.at,
                                              {value_of(trial.p),
                                               value_of(trial.q),
                                               value_of(trial.bulk),
                                               value_of(trial.shear),
                                               value_of(trial.compaction)});
    if (!found.converged)
      return false;
    point.surface = found.surface;
    point.strain_share = strain_share;
    point.p = trial.p;
    if (found.surface == Surface::none)
      return true;

    const Number x = lift(trial, found);
    point.compaction = trial.compaction + x;
    point.at = found.at;
    point.p = trial.p - trial.bulk * x;
    const Number ratio = deviator_ratio(found.surface == Surface::cap,
                                        carry(point.at, point.compaction),
                                        trial,
                                        point.p,
                                        x);
    point.old_share *= ratio;
    point.strain_share *= ratio;
    point.plastic_shear +=
        value_of(trial.q) * (1 - value_of(ratio)) / (3 * value_of(trial.shear));
    return true;
  }

  /// q of old_share s_0 + strain_share e. Its value is that of the sum: the
  /// invariants would lose half of the digits close to q = 0. What is
  /// round-off in stresses of the size of a surface is zero, in all directions.
  Number deviatoric(const Number &old_share,
                    const Number &strain_share,
                    const CapSurface<ByCompaction> &at) const
  {
    const Six s = deviator_of(value_of(old_share), value_of(strain_share));
    const double q = std::sqrt(1.5 * contract(s, s));
    if (q <= 1e-14 * value_of(at.strength))
      return 0.;
    if constexpr (std::is_same_v<Number, double>)
      return q;
    else {
      Number result = 0.75 / q *
                      (old_share * old_share * contract(old_, old_) +
                       2. * old_share * strain_share * mixed_ +
                       strain_share * strain_share * square_);
      result.val() = q;
      return result;
    }
  }

  /// d stress / d strain: s and p are functions of v, w and u, and dv = -1 : d
  /// strain, dw = s_0 : d strain, du = 2 e : d strain.
  SymmetricTensor<4, 3> tangent() const
  {
    const auto slope = [this](const Number &y) {
      Six by;
      for (unsigned k = 0; k < 6; ++k)
        by[k] = y.dx(1) * old_[k] + 2 * y.dx(2) * strain_[k] -
                (k < 3 ? y.dx(0) : 0);
      return by;
    };
    const Six by_old = slope(point_.old_share),
              by_strain = slope(point_.strain_share), by_p = slope(point_.p);
    const double share = point_.strain_share.val();
    SymmetricTensor<4, 3> result;
    for (unsigned m = 0; m < 6; ++m)
      for (unsigned k = 0; k < 6; ++k) {
        double &entry = result.access_raw_entry(6 * m + k);
        entry = old_[m] * by_old[k] + strain_[m] * by_strain[k];
        if (m < 3)
          entry -= by_p[k] + (k < 3 ? share / 3 : 0);
        if (m == k)
          entry += m < 3 ? share : share / 2;
      }
    return result;
  }

  const DruckerPragerCapParameters &parameters_;
  CapTables tables_;
  const Six old_, strain_;
  Number volume_, mixed_, square_; ///< v, w, u
  const double size_;
  Point<Number> point_;
  bool is_resolved_ = true;
};

template <class Number>
std::optional<CapAnswer> answer(Increment<Number> increment)
{
  if (!increment.integrate())
    return {};
  return increment.answer();
}
} // namespace

std::optional<CapAnswer>
integrate_cap(const DruckerPragerCapParameters &parameters,
              const DruckerPragerCap::State &old,
              const SymmetricTensor<2, 3> &strain,
              const Want want)
{
  return want == Want::stress
             ? answer(Increment<double>(parameters, old, strain))
             : answer(Increment<ByInvariants>(parameters, old, strain));
}
} // namespace tamp::fem
