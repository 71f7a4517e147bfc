// SPDX-License-Identifier: BSD-3-Clause
#include <fem/shared_points.h>
#include <tests/fem/same_everywhere.h>

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <memory>
#include <stdexcept>
#include <string>

namespace tamp::fem
{
namespace
{
constexpr std::size_t count = 60;

/// Points whose state is what they were told, summed up, and that count what an
/// evaluation costs: nine times as much in the first half of the run's points.
class CountingPoints final : public MovablePoints
{
public:
  explicit CountingPoints(const Share &share) { hold(share); }

  std::size_t size() const override { return share_.size(); }
  void evaluate(std::span<const Deformation> deformations,
                Want want,
                std::span<Response> responses) override
  {
    for (std::size_t i = 0; i < size(); ++i) {
      trial_[i] = committed_[i] + deformations[i].relative_F[0][0];
      responses[i].stress[0][0] = trial_[i];
      responses[i].relative_density = 1. / (1 + double(share_.begin + i));
      responses[i].status =
          share_.begin + i == bad ? Status::failed : Status::converged;
      if (want == Want::stress_and_tangent)
        responses[i].tangent[0][0][2][2] = 2 * trial_[i];
    }
  }
  void commit() override { committed_ = trial_; }
  void pack(std::size_t i, std::vector<char> &bytes) const override
  {
    const auto *begin = reinterpret_cast<const char *>(&committed_[i]);
    bytes.insert(bytes.end(), begin, begin + sizeof committed_[i]);
  }
  void unpack(std::size_t i, std::span<const char> bytes) override
  {
    if (bytes.size() != sizeof committed_[i])
      throw std::runtime_error("these are " + std::to_string(bytes.size()));
    std::memcpy(&committed_[i], bytes.data(), bytes.size());
  }
  double cost(std::size_t i) const override
  {
    return share_.begin + i < count / 2 ? 9 : 1;
  }
  std::vector<Variable> variables() const override
  {
    return {{"state", "-", "summed up"}};
  }
  void variables_of(std::size_t i, std::span<double> values) const override
  {
    values[0] = committed_[i];
  }
  Share share() const override { return share_; }
  void hold(const Share &share) override
  {
    std::vector<double> kept(share.size(), -1e9);
    for (std::size_t i = share.begin; i < share.end; ++i)
      if (share_.holds(i))
        kept[i - share.begin] = committed_[i - share_.begin];
      else if (!started_)
        kept[i - share.begin] = 0.1 * double(i);
    committed_ = trial_ = kept;
    share_ = share;
    started_ = true;
  }

  std::size_t bad = count; ///< this point fails

private:
  Share share_;
  std::vector<double> committed_, trial_;
  bool started_ = false;
};

std::vector<Deformation> told(double step)
{
  std::vector<Deformation> all(count);
  for (std::size_t i = 0; i < count; ++i)
    all[i].relative_F[0][0] = 1 / (step + double(i));
  return all;
}

std::vector<double> numbers(const std::vector<Response> &responses)
{
  std::vector<double> all;
  for (const Response &response : responses) {
    all.push_back(response.stress[0][0]);
    all.push_back(response.tangent[0][0][2][2]);
    all.push_back(response.relative_density);
    all.push_back(static_cast<double>(response.status));
  }
  return all;
}

class SharedPointsTest : public testing::Test
{
protected:
  const Ranks ranks = Ranks(MPI_COMM_WORLD);
  CountingPoints *own = new CountingPoints(ranks.share(count));
  SharedPoints points{std::unique_ptr<MovablePoints>(own), count, ranks};
};
} // namespace

TEST(BalancedShares, AreTheBestThereAre)
{
  const std::vector<double> weights{5, 1, 1, 1, 1, 1, 2, 2, 6, 0, 0};
  // 5 1 1 | 1 1 1 2 2 | 6: no three ranges have less than 7 in the largest.
  EXPECT_EQ(balanced_shares(weights, 3), (Begins{0, 3, 8, 11}));
  const std::vector<double> alike(12, 0.1);
  EXPECT_EQ(balanced_shares(alike, 4), (Begins{0, 3, 6, 9, 12}));
  // One thing outweighs all others.
  EXPECT_EQ(loads_of(std::vector<double>{1, 9, 1},
                     balanced_shares(std::vector<double>{1, 9, 1}, 3)),
            (std::vector<double>{1, 9, 1}));
}

TEST(BalancedShares, CoverEverythingWithMorePartsThanThings)
{
  const Begins begins = balanced_shares(std::vector<double>{2, 2}, 4);
  ASSERT_EQ(begins.size(), 5u);
  EXPECT_EQ(begins.front(), 0u);
  EXPECT_EQ(begins.back(), 2u);
  EXPECT_TRUE(std::is_sorted(begins.begin(), begins.end()));
  EXPECT_EQ(balanced_shares(std::vector<double>(5, 0.), 2).back(), 5u);
}

TEST_F(SharedPointsTest, AnswerAsOneRankDoes)
{
  CountingPoints alone({0, count});
  for (unsigned step = 1; step <= 5; ++step) {
    const Want want = step % 2 == 0 ? Want::stress : Want::stress_and_tangent;
    std::vector<Response> answers(count), wanted(count);
    points.evaluate(told(step), want, answers);
    alone.evaluate(told(step), want, wanted);
    EXPECT_EQ(numbers(answers), numbers(wanted)) << "step " << step;
    points.commit();
    alone.commit();
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<char> bytes, expected;
      points.pack(i, bytes);
      alone.pack(i, expected);
      ASSERT_EQ(bytes, expected) << "point " << i << ", step " << step;
      double value = 0, same = 1;
      points.variables_of(i, {&value, 1});
      alone.variables_of(i, {&same, 1});
      ASSERT_EQ(value, same);
    }
  }
}

TEST_F(SharedPointsTest, AnUnevenLoadIsBalancedAfterAStep)
{
  const auto loads = [&] {
    std::vector<double> sums(ranks.size(), 0.);
    for (std::size_t i = points.share().begin; i < points.share().end; ++i)
      sums[ranks.rank()] += points.cost(i);
    ranks.sum(sums);
    return sums;
  };
  std::vector<Response> answers(count);
  points.evaluate(told(1), Want::stress, answers);
  const double before = idle_share(loads());
  points.commit();
  const double after = idle_share(loads());
  // 270 and 30 of 300 in two halves; nines can be parted to 5 of 150 or 75.
  if (ranks.size() > 1) {
    EXPECT_GT(before, 0.4);
    EXPECT_LT(after, 0.1);
    EXPECT_GT(points.loads().moved, 0u);
    EXPECT_GT(points.loads().idle.back(), 0.8); // so far
  }
  // What is balanced stays where it is.
  const std::size_t moved = points.loads().moved;
  points.evaluate(told(2), Want::stress, answers);
  points.commit();
  EXPECT_EQ(points.loads().moved, moved);
}

TEST_F(SharedPointsTest, TakeUpStatesByTheNumberOfThePoint)
{
  const double state = 7;
  std::vector<char> bytes(sizeof state);
  std::memcpy(bytes.data(), &state, sizeof state);
  for (const std::size_t point : {std::size_t(0), count / 2, count - 1}) {
    points.unpack(point, bytes);
    std::vector<char> now;
    points.pack(point, now);
    EXPECT_EQ(now, bytes);
  }
  bytes.pop_back();
  EXPECT_THROW(points.unpack(count - 1, bytes), std::runtime_error);
}

TEST_F(SharedPointsTest, EveryRankIsToldOfAFailure)
{
  own->bad = count - 2;
  std::vector<Response> answers(count);
  points.evaluate(told(1), Want::stress, answers);
  for (std::size_t i = 0; i < count; ++i)
    EXPECT_EQ(answers[i].status == Status::failed, i == count - 2);
}

TEST_F(SharedPointsTest, RanksThatAreToldDifferentThingsStop)
{
  auto deformations = told(1);
  if (ranks.rank() + 1 == ranks.size())
    deformations[3].relative_F[2][1] += 1e-16; // of zero
  std::vector<Response> answers(count);
  if (ranks.size() > 1) {
    EXPECT_THROW(points.evaluate(deformations, Want::stress, answers),
                 std::runtime_error);
  }
}

TEST(SharedPoints, RefuseSharesThatAreNotEqual)
{
  const Ranks ranks(MPI_COMM_WORLD);
  EXPECT_THROW(SharedPoints(std::make_unique<CountingPoints>(Share{0, count}),
                            count + 1,
                            ranks),
               std::invalid_argument);
}

TEST(Ranks, TellEachOtherBytesAndTexts)
{
  const Ranks ranks(MPI_COMM_WORLD);
  const std::vector<char> own(ranks.rank() + 1, char('a' + ranks.rank()));
  std::string wanted;
  for (unsigned rank = 0; rank < ranks.size(); ++rank)
    wanted += std::string(rank + 1, char('a' + rank));
  const std::vector<char> all = ranks.join(own);
  EXPECT_EQ(std::string(all.begin(), all.end()), wanted);
  EXPECT_EQ(ranks.first_text(""), "");
  const std::string text(ranks.rank() > 0 ? ranks.rank() : 0, 'x');
  EXPECT_EQ(ranks.first_text(text), ranks.size() > 1 ? "x" : "");
}
} // namespace tamp::fem
