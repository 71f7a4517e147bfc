// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/cap_increment.h>
#include <fem/laws/cap_point.h>

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

/// A part is never shorter than 2^-10 of the plastic way.
constexpr unsigned most_halvings = 10;

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
        square_(contract(strain_, strain_))
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
    const auto moduli = tables_.moduli(value_of(point_.compaction));
    const Number share = elastic_share(moduli);
    point_.p += moduli.bulk.val() * share * volume_;
    point_.strain_share += 2 * moduli.shear.val() * share;
    if (value_of(share) < 1 && !advance(1. - share, most_halvings))
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
  /// The gauge of the surface after an elastic share of the increment, with its
  /// derivative by the share.
  ByCompaction gauge_after(const double share,
                           const CapModuli<ByCompaction> &moduli) const
  {
    const double shear = 2 * moduli.shear.val();
    const Six s = deviator_of(1, shear * share);
    const double q = std::sqrt(1.5 * contract(s, s)),
                 rate = moduli.bulk.val() * value_of(volume_);
    ByCompaction p(1, 0, value_of(point_.p) + share * rate), height(1, 0, q);
    p.fastAccessDx(0) = rate;
    height.fastAccessDx(0) = q > 0 ? 1.5 * shear * contract(s, strain_) / q : 0;
    return carry(point_.at, ByCompaction(value_of(point_.compaction)))
        .gauge(p, height);
  }

  /// The share of the increment after which the elastic way leaves the surface,
  /// 1 if it does not. The gauge of the surface is convex along the way, so
  /// Newton's method finds the last crossing from outside; it falls to 0 if the
  /// way starts on the surface and leads out.
  Number elastic_share(const CapModuli<ByCompaction> &moduli) const
  {
    double share = 1, slope = 0;
    for (unsigned iteration = 0; iteration < 100; ++iteration) {
      const ByCompaction gauge = gauge_after(share, moduli);
      if (gauge.val() <= 1 + 1e-14)
        break;
      slope = gauge.fastAccessDx(0);
      const double next = share - (gauge.val() - 1) / slope;
      if (!(next > 0))
        return 0.;
      if (next >= share)
        break;
      share = next;
    }
    if (share >= 1)
      return 1.;
    CapPoint<Number> there = point_; // a Newton step that carries derivatives
    there.p += moduli.bulk.val() * share * volume_;
    there.strain_share += 2 * moduli.shear.val() * share;
    Number result = -1. / slope * gauge(there);
    if constexpr (!std::is_same_v<Number, double>)
      result.val() = share;
    else
      result = share;
    return result;
  }

  /// A share of the increment in one part and in two, which makes an answer of
  /// second order and an estimate of error; where that is too large, or a part
  /// does not converge, the same for its halves. Between once and twice the
  /// tolerance the answer is a mixture of both, so that it is a smooth function
  /// of the strain.
  /// @param known  the share in one part, if it is known.
  bool advance(const Number &share,
               const unsigned halvings,
               const CapPoint<Number> *known = nullptr)
  {
    CapPoint<Number> whole = known ? *known : point_;
    bool good = known || part(whole, share);
    if (good && whole.surface == Surface::none) {
      point_ = whole;
      return true;
    }
    CapPoint<Number> half = point_;
    const bool half_good = part(half, 0.5 * share);
    CapPoint<Number> both = half;
    good = good && half_good && part(both, 0.5 * share);
    const Number size = good ? excess(whole, both, share) : Number(2.);
    if (good && (value_of(size) <= 1 || halvings == 0)) {
      point_ = joined(whole, both);
      is_resolved_ = is_resolved_ && value_of(size) <= 1;
      return true;
    }
    if (halvings == 0 ||
        !advance(0.5 * share, halvings - 1, half_good ? &half : nullptr) ||
        !advance(0.5 * share, halvings - 1))
      return false;
    if (value_of(size) < 2) {
      const Number over = size - 1.;
      point_ = mixed(
          point_, joined(whole, both), 1. - over * over * (3. - 2. * over));
    }
    return true;
  }

  /// What is too large if it is above 1: the difference of two stresses, over
  /// its tolerance, or the strain. A hundredth of the size of the surface is
  /// added to the stress so that stresses close to zero need no better.
  Number excess(const CapPoint<Number> &one,
                const CapPoint<Number> &two,
                const Number &share) const
  {
    using std::sqrt;
    const auto norm = [this, &two](const Number &old_share,
                                   const Number &strain_share,
                                   const Number &p) {
      const Number q = deviatoric(old_share, strain_share, two.at);
      const Number square = q * q / 1.5 + 3. * p * p;
      return value_of(square) > 0 ? Number(sqrt(square)) : Number(0.);
    };
    const auto s = carry(two.at, two.compaction);
    const Number difference = norm(one.old_share - two.old_share,
                                   one.strain_share - two.strain_share,
                                   one.p - two.p) /
                              (norm(two.old_share, two.strain_share, two.p) +
                               0.01 * (s.radius() + s.strength)) /
                              parameters_.integration_tolerance;
    const Number size = share * sqrt(square_ + volume_ * volume_ / 3.) /
                        parameters_.maximum_strain_increment;
    return value_of(size) > value_of(difference) ? size : difference;
  }

  Six deviator_of(const double old_share, const double strain_share) const
  {
    Six s;
    for (unsigned k = 0; k < 6; ++k)
      s[k] = old_share * old_[k] + strain_share * strain_[k];
    return s;
  }
  Six deviator_of(const CapPoint<Number> &point) const
  {
    return deviator_of(value_of(point.old_share), value_of(point.strain_share));
  }

  /// (1 - share) one + share two, drawn in the direction of the surface's
  /// centre to where the same holds for the gauge.
  CapPoint<Number> mixed(const CapPoint<Number> &one,
                         const CapPoint<Number> &two,
                         const Number &share)
  {
    const auto mix = [&share](const auto &a, const auto &b) {
      return Number(a + share * (b - a));
    };
    CapPoint<Number> point = two;
    point.old_share = mix(one.old_share, two.old_share);
    point.strain_share = mix(one.strain_share, two.strain_share);
    point.p = mix(one.p, two.p);
    point.compaction = mix(one.compaction, two.compaction);
    point.plastic_shear = value_of(mix(one.plastic_shear, two.plastic_shear));
    point.at = tables_.surface(value_of(point.compaction));
    const Number target =
        one.surface != Surface::none && two.surface != Surface::none
            ? Number(1.)
            : mix(gauge(one), gauge(two));
    const Number ratio =
        (value_of(target) < 1 ? target : Number(1.)) / gauge(point);
    const auto s = carry(point.at, point.compaction);
    point.old_share *= ratio;
    point.strain_share *= ratio;
    point.p = s.centre + (point.p - s.centre) * ratio;
    return point;
  }

  Number gauge(const CapPoint<Number> &point) const
  {
    return carry(point.at, point.compaction)
        .gauge(point.p,
               deviatoric(point.old_share, point.strain_share, point.at));
  }

  /// From the same share in one part and in two, each with an error of second
  /// order in it: what has one of third order.
  CapPoint<Number> joined(const CapPoint<Number> &one,
                          const CapPoint<Number> &two)
  {
    return mixed(one, two, Number(2.));
  }

  /// One backward Euler part. False, and nothing changed, if the return did
  /// not meet its tolerance.
  bool part(CapPoint<Number> &point, const Number &share)
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
  CapPoint<Number> point_;
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
