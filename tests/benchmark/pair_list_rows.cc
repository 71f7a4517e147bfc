// SPDX-License-Identifier: BSD-3-Clause
#include <dem/neighbours.h>
#include <tests/benchmark/rows.h>

#include <memory>
#include <vector>

// Time to list pairs anew: the outer list from the places, and the inner list
// from the outer one.
namespace tamp::speed
{
namespace
{
using namespace tamp::dem;

/// A cell and its lists, made when they are first asked for.
class Lists
{
public:
  Lists(Packings &packings, std::size_t count)
      : packings_(packings), count_(count)
  {
  }
  void list_outer()
  {
    const UnitCell &from = cell();
    outer_ = find_neighbours(
        from.box, from.place, from.radius, 0.3 * from.mean_radius());
  }
  void list_inner()
  {
    const UnitCell &from = cell();
    if (outer_.pairs.empty())
      list_outer();
    find_near_pairs(outer_,
                    from.box,
                    from.place,
                    from.radius,
                    0.06 * from.mean_radius(),
                    inner_);
  }

private:
  const UnitCell &cell()
  {
    if (cell_.size() == 0)
      cell_ = packings_.repeated(count_);
    return cell_;
  }

  Packings &packings_;
  std::size_t count_;
  UnitCell cell_;
  Neighbours outer_;
  std::vector<NearPair> inner_;
};
} // namespace

void add_pair_lists(Packings &packings)
{
  for (std::size_t count : {1000, 5000}) {
    const auto lists = std::make_shared<Lists>(packings, count);
    add_time("pairs.outer" + of_grains(count), [=] { lists->list_outer(); });
    add_time("pairs.inner" + of_grains(count), [=] { lists->list_inner(); });
  }
}
} // namespace tamp::speed
